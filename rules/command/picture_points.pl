:- module(sg_picture_points,
          [ picture_numbered/4          % +Options, +Lines, +Options0,
                                        % -Options1
          ]).
:- use_module('../csg/csg_roots', [with_operand_lines/2]).
:- use_module('../sheet/line_point', [line_points/2, points_added/5]).
:- use_module('../sheet/sheet', [sheet_strokes/5]).
:- use_module(sheet_options, [points_wanted/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The option --points of draw, in a picture without a sheet.
*/

%!  picture_numbered(+Options, +Lines, +Options0, -Options1) is det.
%
%   Options1 are Options0, of write_drawing/2, for the picture of the current
%   world with numbered points, where Options ask for them. Lines are those of
%   operands.
%
%   @error usage_error(both_options(A, B)), and that of points_wanted/2

picture_numbered(Options, Lines, Options0, Options1) :-
    (   points_wanted(Options, Most)
    ->  (   option(png(dots), Options)
        ->  usage_error(both_options('--points', '--png dots'))
        ;   true
        ),
        with_operand_lines(Lines, line_points(Most, Points)),
        sheet_strokes(210-148, Options0, Sheet, Place, Strokes),
        option(drawing(Drawing0), Options0,
               drawing(Sheet,[view('',Strokes,[])])),
        option(hidden(Hidden), Options0, dashed),
        points_added(Hidden, Points, Place, Drawing0, Drawing),
        exclude(is_drawing, Options0, Rest),
        Options1 = [drawing(Drawing)|Rest]
    ;   Options1 = Options0
    ).

is_drawing(drawing(_)).
