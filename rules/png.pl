:- module(sg_png,
          [ write_png/2                 % +Out, +Options
          ]).
:- use_module(dot_drawing, [write_dots/2]).
/** <module> PNG: a drawing as a picture in dots.
*/

%!  write_png(+Out, +Options) is det.
%
%   Write the picture of the current world as PNG to stream Out. Options as
%   for write_drawing/2.

write_png(Out, Options) :-
    stream_property(Out, encoding(Encoding)),
    setup_call_cleanup(
        set_stream(Out, encoding(octet)),
        write_dots(Out, Options),
        set_stream(Out, encoding(Encoding))).
