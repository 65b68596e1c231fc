:- module(sg_picture_marks,
          [ picture_marked/5            % +Options, +Seen, +Lines, +Options0,
                                        % -Options1
          ]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../csg/csg_roots', [aside_segments/1, with_operand_lines/2]).
:- use_module('../picture/view', [current_view/4, with_up/2]).
:- use_module('../picture/operand_line', [crossing_lines/2]).
:- use_module('../sheet/line_point', [line_points/2, points_added/5]).
:- use_module('../sheet/sheet', [sheet_strokes/5]).
:- use_module('../sheet/sheet_construction', [centres_added/4]).
:- use_module('../sheet/sheet_view', [view_centres/3]).
:- use_module('../sheet/stroke', [all_strokes/2]).
:- use_module(sheet_options, [points_wanted/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [exclude/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The options --points and --centre-lines of draw, in a picture
without a sheet.
*/

%!  picture_marked(+Options, +Seen, +Lines, +Options0, -Options1) is det.
%
%   Options1 are Options0, of write_drawing/2, for the picture of the current
%   world with numbered points and centre lines, where Options ask for them.
%   Seen is seen(Up, Picture): the picture was made with these options, while
%   the world was turned so that its axis Up points up. Lines are those of
%   operands.
%
%   @error usage_error(both_options(A, B)), and that of points_wanted/2

picture_marked(Options, Seen, Lines, Options0, Options1) :-
    (   setof(Mark, mark_wanted(Options, Mark), Marks)
    ->  (   option(png(dots), Options)
        ->  Marks = [Mark|_],
            mark_option(Mark, Name),
            usage_error(both_options(Name, '--png dots'))
        ;   true
        ),
        sheet_strokes(210-148, Options0, Sheet, Place, Strokes),
        option(drawing(Drawing0), Options0,
               drawing(Sheet,[view('',Strokes,[])])),
        single_drawing(Drawing0, Drawing1),
        added(Marks, Seen, Lines, Options0, Place, Drawing1, Drawing),
        exclude(is_drawing, Options0, Rest),
        Options1 = [drawing(Drawing)|Rest]
    ;   Options1 = Options0
    ).

single_drawing(drawing(Sheet,Views0), drawing(Sheet,Views)) :-
    findall(view(Name,Strokes,Texts),
            ( member(view(Name,Strokess,Texts), Views0),
              all_strokes(Strokess, Strokes) ),
            Views).

mark_wanted(Options, centre_lines) :-
    option('centre-lines'(true), Options).
mark_wanted(Options, points(Most)) :-
    points_wanted(Options, Most).

mark_option(centre_lines, '--centre-lines').
mark_option(points(_), '--points').

added([], _, _, _, _, Drawing, Drawing).
added([Mark|Marks], Seen, Lines, Options0, Place, Drawing0, Drawing) :-
    mark_added(Mark, Seen, Lines, Options0, Place, Drawing0, Drawing1),
    added(Marks, Seen, Lines, Options0, Place, Drawing1, Drawing).

mark_added(centre_lines, seen(Up,Picture0), _, _, Place, Drawing0, Drawing) :-
    current_view(Theta, Phi, _, Kind),
    (   Kind == parallel
    ->  true
    ;   usage_error(both_options('--centre-lines', '--projection central'))
    ),
    picture_of_roots(Picture0, Picture),
    with_up(Up, view_centres(view('',Theta,Phi,plain), Picture, Centres)),
    centres_added(Centres, Place, Drawing0, Drawing).
mark_added(points(Most), _, Lines, Options0, Place, Drawing0, Drawing) :-
    crossing_lines(Lines, Crossing),
    with_operand_lines(Crossing, line_points(Most, Points)),
    option(hidden(Hidden), Options0, dashed),
    points_added(Hidden, Points, Place, Drawing0, Drawing).

picture_of_roots(Picture0, Picture) :-
    (   aside_segments([_|_]),
        \+ option(segments(_), Picture0)
    ->  findall(S, root_segment(S), Roots),
        Picture = [segments(Roots)|Picture0]
    ;   Picture = Picture0
    ).

is_drawing(drawing(_)).
