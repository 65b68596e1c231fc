:- module(sg_lettering,
          [ lettering/2                 % +Text, -Lines
          ]).
/** <module> Lettering: texts as lines of a pen.
*/

%!  lettering(+Text, -Lines) is det.
%
%   Lines are the letters of Text, text(X,Y,Height,Anchor,Text): lists of
%   points, X-Y, in its unit.

lettering(_, []).
