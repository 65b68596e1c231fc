:- module(sg_picture_options,
          [ picture_options/2,          % +Options, -Picture
            known_segments/1,           % +Picture
            drawing_options/2,          % +Options, -Drawing
            eye/2                       % +Options, -Goals
          ]).
:- use_module('../sheet/eye', [set_eye/3]).
:- use_module('../picture/role', [usual_crease/1]).
:- use_module(sheet_options, [looking/2, scale_option/2]).
:- use_module('../store', [segment/3, line/9]).
:- use_module('../drawing/style_file', [style_rows/2]).
:- use_module(verb_output, [usage_error/1]).
:- use_module('../picture/view', [set_view/1, set_view/3, set_projection/1]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The options of a picture: what is drawn, from where, and how.
*/

%!  picture_options(+Options:list, -Picture:list) is det.
%
%   Picture are those of picture/1 among the Options of a verb.
%
%   @error usage_error(bad_value('--segment', Text, 'N'))

picture_options(Options, Picture) :-
    option(lines(Lines), Options, feature),
    usual_crease(Usual),
    option(crease(Crease), Options, Usual),
    (   option(segment(Texts), Options)
    ->  maplist(segment_number, Texts, Ss),
        Picture = [lines(Lines), crease(Crease), segments(Ss)]
    ;   Picture = [lines(Lines), crease(Crease)]
    ).

segment_number(Text, S) :-
    (   atom_number(Text, S),
        integer(S),
        S > 0
    ->  true
    ;   usage_error(bad_value('--segment', Text, 'N'))
    ).

%!  known_segments(+Picture:list) is det.
%
%   True when the segments that Picture names are there.
%
%   @error usage_error(no_segment(S, All))

known_segments(Picture) :-
    (   option(segments(Ss), Picture),
        member(S, Ss),
        \+ segment(S, _, _)
    ->  findall(Known, segment(Known, _, _), All),
        usage_error(no_segment(S, All))
    ;   true
    ).

%!  drawing_options(+Options:list, -Drawing:list) is det.
%
%   Drawing are those of write_drawing/2 among Options.
%
%   @error usage_error(What): no_size('--size', Size), bad_value('--size', ...)

drawing_options(Options, Drawing) :-
    findall(Option, drawing_option(Options, Option), Drawing).

drawing_option(Options, hidden(Hidden)) :-
    option(hidden(Hidden), Options).
drawing_option(Options, style(Rows)) :-
    option(style(File), Options),
    style_rows(File, Rows).
drawing_option(Options, dashes(How)) :-
    option(dashes(How), Options).
drawing_option(Options, min_line(Length)) :-
    option('min-line'(Length), Options).
drawing_option(Options, png(How)) :-
    option(png(How), Options).
drawing_option(Options, dots(Dots)) :-
    option(dpi(DotsPerInch), Options),
    Dots is DotsPerInch/25.4.
drawing_option(Options, scale(Scale)) :-
    scale_option(Options, Scale).
drawing_option(Options, size(Size)) :-
    option(size(Size), Options),
    (   split_string(Size, "x", "", Parts),
        maplist(number_of, Parts, [W, H])
    ->  (   W > 0,
            H > 0
        ->  true
        ;   usage_error(no_size('--size', Size))
        )
    ;   usage_error(bad_value('--size', Size, 'WxH'))
    ).

number_of(Text, Number) :-
    catch(number_string(Number, Text), error(_, _), fail).

%!  eye(+Options:list, -Goals:list) is det.
%
%   Goals set the view and the projection that Options ask for.

eye(Options, Goals) :-
    findall(sg_picture_options:Goal, eye_goal(Options, Goal), Goals).

eye_goal(Options, Goal) :-
    looking(Options, View),
    (   View = eye(Eye, Target)
    ->  option(projection(Kind), Options, parallel),
        Goal = set_eye(Eye, Target, Kind)
    ;   View = view(_, Theta, Phi, _),
        eye_distance(Options, Rho),
        Goal = set_view(Theta, Phi, Rho)
    ).
eye_goal(Options, set_projection(Kind)) :-
    option(projection(Kind), Options).

%   eye_distance(Options, Rho): 0 is as far as needed.

eye_distance(Options, Rho) :-
    (   option(view(View), Options),
        split_string(View, ",", " ", [_, _, Text]),
        number_of(Text, Rho0)
    ->  Rho = Rho0
    ;   Rho = 0
    ).
