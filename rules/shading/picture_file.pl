:- module(sg_picture_file,
          [ render/2                    % +File, +Options
          ]).
:- use_module('../kernel', [image_png/3, image_ppm/2]).
:- use_module('../output', [writing/3]).
:- use_module(kept_picture, [world_picture/2]).
:- use_module(library(error), [domain_error/2, must_be/2]).
/** <module> A shaded picture of the current world as a file, again and again.
*/

%!  render(+File, +Options) is det.
%
%   Writes a shaded picture of the solids of the current world to File, PNG or
%   PPM by its ending. Options are size(W-H), window(b(X1,Y1,X2,Y2)), smooth(N),
%   shade(S), colours(By), background(C), edges(Bool), shadows(Bool),
%   palette(N), as of `sanggwan render`. After an edit only the rows are made
%   again where it shows; the frame stays as long as the options and the view
%   do.
%
%   @error domain_error(picture_file, File): another ending
%   @error as of shaded_model/2 and shaded_eye/3

render(File, Options) :-
    must_be(text, File),
    must_be(list, Options),
    file_name_extension(_, Ending, File),
    downcase_atom(Ending, Format),
    (   memberchk(Format, [png,ppm])
    ->  true
    ;   domain_error(picture_file, File)
    ),
    world_picture(Options, Image),
    writing(File, binary, sg_picture_file:image_bytes(Format, Image)).

image_bytes(png, Image, Out) :-
    image_png(Image, 0, Out).
image_bytes(ppm, Image, Out) :-
    image_ppm(Image, Out).
