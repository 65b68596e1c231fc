:- module(sg_laid_joint,
          [ joint_edges/4,              % +Flattening, +J, -E1, -E2
            joint_faces/4,              % +Flattening, +J, -P1, -P2
            joint_length/3,             % +Flattening, +J, -Length
            joint_middle/3,             % +Flattening, +J, -Point
            joint_kind/3,               % +Flattening, +J, -Kind
            joint_state/3               % +Flattening, +J, -State
          ]).
:- use_module('../kernel', [flattening_joint/3]).
/** <module> What a joint of a flattening is: flattening_joint/3 by name.
*/

%!  joint_edges(+Flattening, +J, -E1, -E2) is det.
%!  joint_faces(+Flattening, +J, -P1, -P2) is det.
%
%   Joint J has edge E1 of polygon P1, and its partner E2 of P2.

joint_edges(Flattening, J, E1, E2) :-
    flattening_joint(Flattening, J, joint(E1,E2,_,_,_,_,_,_,_)).

joint_faces(Flattening, J, P1, P2) :-
    flattening_joint(Flattening, J, joint(_,_,P1,P2,_,_,_,_,_)).

%!  joint_length(+Flattening, +J, -Length) is det.
%
%   Length is that of its edges.

joint_length(Flattening, J, Length) :-
    flattening_joint(Flattening, J, joint(_,_,_,_,Length,_,_,_,_)).

%!  joint_middle(+Flattening, +J, -Point) is det.
%
%   Point, p(X,Y,Z), is the middle of its edges in the model.

joint_middle(Flattening, J, Point) :-
    flattening_joint(Flattening, J, joint(_,_,_,_,_,Point,_,_,_)).

%!  joint_kind(+Flattening, +J, -Kind) is det.
%!  joint_state(+Flattening, +J, -State) is det.
%
%   Kind and State are as in flattening_joint/3.

joint_kind(Flattening, J, Kind) :-
    flattening_joint(Flattening, J, joint(_,_,_,_,_,_,_,Kind,_)).

joint_state(Flattening, J, State) :-
    flattening_joint(Flattening, J, joint(_,_,_,_,_,_,_,_,State)).
