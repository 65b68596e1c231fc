:- module(sg_verbs_shading,
          [ shade_asked/3,              % +Options, +Outputs, -Shade
            shade_taken/3,              % +Shade, +Options, -Shading
            eye_away/2,                 % +Options, -Away
            picture_shaded/5,           % +Shade, +Shading, +Away,
                                        % +Options0, -Options
            sheet_shaded/6              % +Shade, +Shading, +Placed,
                                        % +Drawing0, -Drawing, -Options
          ]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../drawing/drawing_shading',
              [shaded_view/5, shading_strokes/2, shading_taken/3]).
:- use_module('../picture/view', [set_projection/1, set_view/3]).
:- use_module('../shading/shading_scene', [is_shaded/1]).
:- use_module('../sheet/eye', [eye_target/2]).
:- use_module('../sheet/sheet', [sheet_strokes/5]).
:- use_module('../store', [facts_snapshot/1]).
:- use_module(sheet_options, [looking/2]).
:- use_module(shading_words, [shade_named/3, up_matrix/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module(library(apply), [foldl/4, include/3, maplist/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The option --shade of draw: shading under the lines.
*/

%!  shade_asked(+Options, +Outputs, -Shade) is det.
%
%   Shade is what --shade says: a shade of render, `hatch`, or `none`.
%
%   @error usage_error(bad_value('--shade', Text, Form)),
%          usage_error(shade_in_dots(Format)), usage_error(both_options(A, B))

shade_asked(Options, Outputs, Shade) :-
    (   option(shade(Text), Options)
    ->  shade_named(Text, [hatch], Shade),
        (   option(png(dots), Options)
        ->  usage_error(both_options('--shade', '--png dots'))
        ;   Shade \== hatch,
            member(output(_, Format), Outputs),
            \+ memberchk(Format, [svg,pdf,eps,ps,png])
        ->  usage_error(shade_in_dots(Format))
        ;   true
        )
    ;   Shade = none
    ).

%!  shade_taken(+Shade, +Options, -Shading) is det.
%
%   Shading is that of the roots that will be drawn, while their trees are
%   there.

shade_taken(none, _, none) :-
    !.
shade_taken(_, Options, Shading) :-
    (   option(segment(Texts), Options)
    ->  findall(S, ( member(Text, Texts), atom_number(Text, S) ), All)
    ;   findall(S, root_segment(S), All)
    ),
    include(is_shaded, All, Roots),
    up_matrix(Options, Matrix),
    shading_taken(Roots, Matrix, Shading).

%!  eye_away(+Options, -Away) is det.
%
%   Away is where the world, turned up, is moved from for --eye.

eye_away(Options, Away) :-
    (   option(projection(central), Options),
        looking(Options, eye(_, Target))
    ->  eye_target(Target, Away)
    ;   Away = [0.0,0.0,0.0]
    ).

%!  picture_shaded(+Shade, +Shading, +Away, +Options0, -Options) is det.
%
%   Options for write_drawing/2 are Options0, with the shading of the picture of
%   the current world.

picture_shaded(none, _, _, Options, Options) :-
    !.
picture_shaded(Shade, Shading, Away, Options0, Options) :-
    sheet_strokes(210-148, Options0, Sheet, Place, Strokes0),
    shaded_view(Shading, Shade, Place, Away, Shaded),
    under_lines(Shade, Shaded, Strokes0, Strokes, More),
    append([drawing(drawing(Sheet,[view('',Strokes,[])]))|More], Options0,
           Options).

%   under_lines(Shade, Shaded, Strokes0, Strokes, Options)

under_lines(hatch, Shaded, Strokes0, Strokes, []) :-
    !,
    shading_strokes(Shaded, Shading),
    append(Shading, Strokes0, Strokes).
under_lines(_, Shaded, Strokes, Strokes, [shading([Shaded])]).

%!  sheet_shaded(+Shade, +Shading, +Placed, +Drawing0, -Drawing,
%!               -Options) is det.
%
%   Drawing is Drawing0 with strokes in its pictorial views, Placed as of
%   views_drawing/5; Options for write_drawing/2 have what is in dots.

sheet_shaded(none, _, _, Drawing, Drawing, []) :-
    !.
sheet_shaded(Shade, Shading, Placed, drawing(Sheet,Views0),
             drawing(Sheet,Views), [shading(Shadeds)]) :-
    foldl(view_shaded(Shade, Shading), Placed, Views0-[], Views-Shadeds).

view_shaded(Shade, Shading, placed(View,Place), Views0-Shadeds0,
            Views-Shadeds) :-
    View = view(Name,Theta,Phi,_),
    facts_snapshot(( set_view(Theta, Phi, 0),
                     set_projection(parallel),
                     shaded_view(Shading, Shade, Place, [0.0,0.0,0.0],
                                 Shaded) )),
    maplist(strokes_under(Name, Shade, Shaded, Options), Views0, Views),
    option(shading(New), Options, []),
    append(Shadeds0, New, Shadeds).

strokes_under(Name, Shade, Shaded, Options, view(Name0,Strokes0,Texts),
              view(Name0,Strokes,Texts)) :-
    (   Name0 == Name
    ->  under_lines(Shade, Shaded, Strokes0, Strokes, Options)
    ;   Strokes = Strokes0
    ).
