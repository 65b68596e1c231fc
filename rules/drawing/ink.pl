:- module(sg_ink,
          [ inked/3,                    % +Drawing, +Options, -Inked
            inked_lines/3,              % +Texts, +Inked, -Lines
            line_of/2,                  % +Lines, -Line
            fold_lines/4,               % :Goal, +Lines, +State0, -State
            inked_texts/2,              % +Inked, -Texts
            inked_inks/2,               % +Inked, -Inks
            dashes_option/3,            % +Options, +Default, -How
            ink_width/2,                % +Ink, -Width
            ink_colour/3,               % +Medium, +Ink, -RGB
            ink_type/2,                 % +Ink, -Type
            ink_runs/2,                 % +Ink, -Runs
            ink_pen/2,                  % +Ink, -Pen
            ink_layer/2,                % +Ink, -Layer
            ink_lines/4                 % +How, +Ink, +Stroke, -Lines
          ]).
:- use_module('../sheet/crossing', [strokes_crossed/2]).
:- use_module('../sheet/dash', [stroke_dashes/3]).
:- use_module('../sheet/stroke', [single_strokes/2, stroke_key/4]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../decision', [decided_at/2, default/1]).
:- use_module('../sheet/speck', [without_specks/3]).
:- use_module('../sheet/lettering', [lettering/2]).
:- use_module(style,
              [ line_style/4, line_type/3, layer_name/1,
                paper_style/1
              ]).
:- use_module(style_file, [style_rows/2, restyled/6, rows_paper/2]).
:- use_module(library(apply),
              [convlist/3, exclude/3, foldl/4, foldl/5, maplist/3]).
:- use_module(library(error), [domain_error/2]).
:- use_module('../plain', [plain_text/2]).
:- use_module(library(lists), [append/2, append/3, list_to_set/2, member/2]).
:- use_module(library(option), [option/3]).
/** <module> Ink: a drawing with the way it looks.

A drawing (sheet.pl) says what is where; inked, it says how it looks too:

    inked(Sheet, Paper, Views)      Paper: rgb(R,G,B)
    view(Name, Lines, Texts)
    line(Ink, Strokes)              one or many (stroke.pl)
    text(Ink, Text)
    word(Ink, Angle, Text)

The texts of a view in a drawing may be word(Role,S,Angle,Text,Strokes), Angle
in thousandths of a degree: a text that is drawn by Strokes, which are among
those of the view in the same order.

An ink is a style (style.pl), checked and in the units of the sheet: the
writers of all formats ask it for its parts, and none of them knows how a line
of some role looks.
*/

:- set_prolog_flag(optimise, true).

%!  inked(+Drawing, +Options, -Inked) is det.
%
%   Inked is Drawing with its inks, less what is not drawn. Options:
%
%     - style(Style): a style file, or its rows; see style_rows/2
%     - hidden(How): `shown` makes the hidden lines solid
%     - words(kept): words are in place of their strokes; else there are none
%     - min_line(L): strokes shorter than L millimetres, at whose ends no other
%       one of the view ends, are left out (speck.pl)
%
%   @error model_error(style(line_style(Style))), model_error(style(colour(C))):
%   a rule file gave what is none, at the error's place; and those of
%   style_rows/2

inked(drawing(Sheet,Views1), Options, inked(Sheet,Paper,Views)) :-
    option(min_line(Least), Options, 0),
    without_specks(Least, Views1, Views0),
    option(style(Style), Options, []),
    style_rows(Style, Rows),
    paper(Rows, Paper),
    option(hidden(Hidden), Options, dashed),
    option(words(Words), Options, drawn),
    maplist(inked_view(Words, how(Rows,Hidden)), Views0, Views).

inked_view(Words, How, view(Name,Strokes0,Texts0), view(Name,Lines,Written)) :-
    worded(Words, Strokes0, Texts0, Strokes, Texts),
    inked_items(Strokes, How, none-none, Lines0),
    lines_crossed(Lines0, Lines),
    inked_items(Texts, How, none-none, Written).

%   lines_crossed(Lines0, Lines): dashed hidden lines know where others of these
%   cross them.

lines_crossed(Lines0, Lines) :-
    convlist(dashed_line, Lines0, Strokess),
    strokes_crossed(Strokess, Strokes),
    (   \+ same_term(Strokess, Strokes)
    ->  foldl(line_marked, Lines0, Lists, Strokes, []),
        append(Lists, Lines)
    ;   Lines = Lines0
    ).

dashed_line(line(Ink,Strokes), Strokes) :-
    stroke_key(Strokes, hidden, _, _),
    ink_runs(Ink, [_,_]).

line_marked(Line, Lines, Strokes0, Strokes) :-
    (   dashed_line(Line, Own)
    ->  Line = line(Ink, _),
        single_strokes(Own, Singles),
        foldl(next_marked(Ink), Singles, Lines, Strokes0, Strokes)
    ;   Lines = [Line],
        Strokes = Strokes0
    ).

next_marked(Ink, _, line(Ink,Stroke), [Stroke|Strokes], Strokes).

worded(kept, Strokes0, Texts, Strokes, Texts) :-
    !,
    foldl(word_strokes, Texts, Letters, []),
    strokes_without(Strokes0, Letters, Strokes).
worded(drawn, Strokes, Texts0, Strokes, Texts) :-
    exclude(is_word, Texts0, Texts).

is_word(word(_,_,_,_,_)).

word_strokes(Text, Letters0, Letters) :-
    (   Text = word(_, _, _, _, Own)
    ->  append(Own, Letters, Letters0)
    ;   Letters0 = Letters
    ).

%   strokes_without(Strokes0, Letters, Strokes): Letters are some of Strokes0,
%   in their order.

strokes_without([], _, []).
strokes_without([Stroke|Strokes0], Letters0, Strokes) :-
    (   Letters0 = [Letter|Letters],
        Letter == Stroke
    ->  Strokes = Strokes1
    ;   Letters = Letters0,
        Strokes = [Stroke|Strokes1]
    ),
    strokes_without(Strokes0, Letters, Strokes1).

%   Neighbours mostly look alike: the last key and its ink are kept.

inked_items([], _, _, []).
inked_items([Item|Items], How, Last, Inked) :-
    item_key(Item, Key),
    (   Last = Key-Ink
    ->  true
    ;   key_ink(How, Key, Ink)
    ),
    (   Ink == none
    ->  Inked = Inked1
    ;   inked_item(Item, Ink, InkedItem),
        Inked = [InkedItem|Inked1]
    ),
    inked_items(Items, How, Key-Ink, Inked1).

item_key(text(_,_,_,_,_), Key) =>
    Key = key(visible,text,0).
item_key(word(Role,S,_,_,_), Key) =>
    Key = key(visible,Role,S).
item_key(Strokes, Key) =>
    Key = key(Visibility,Role,S),
    stroke_key(Strokes, Visibility, Role, S).

inked_item(Strokes, Ink, line(Ink,Strokes)) :-
    stroke_key(Strokes, _, _, _),
    !.
inked_item(text(X,Y,Height,Anchor,Text0), Ink0,
           text(Ink,text(X,Y,Height,Anchor,Text))) :-
    plain_text(Text0, Text),
    letter_ink(Ink0, Height, Ink).
inked_item(word(_,_,Angle,Text0,_), Ink0, word(Ink,Angle,Text)) :-
    inked_item(Text0, Ink0, text(Ink,Text)).

%   Letters are drawn no wider than a tenth of their height (ISO 3098).

letter_ink(ink(Width0,Colours,Type,Runs,Pen,Layer), Height,
           ink(Width,Colours,Type,Runs,Pen,Layer)) :-
    Width is max(1, min(Width0, round(Height/10))).

key_ink(how(Rows,Hidden), key(Visibility,Role,S), Ink) :-
    decided_style(Visibility, Role, S, Style0),
    restyled(Rows, Visibility, Role, S, Style0, Style),
    (   style_ink(Style, Ink0)
    ->  shown_ink(Visibility, Hidden, Ink0, Ink)
    ;   decided_at(line_style(Visibility, Role, S, Style0), Location),
        style_fault(Style, What),
        throw(error(model_error(style(What)), Location))
    ).

%   style_fault(Style, What): of a colour it is said which there are.

style_fault(style(_,Colour,_,_,_), colour(Colour)) :-
    \+ colours(Colour, _),
    !.
style_fault(Style, line_style(Style)).

decided_style(Visibility, Role, S, Style) :-
    (   line_style(Visibility, Role, S, Style0)
    ->  Style = Style0
    ;   once(default(line_style(Visibility, Role, S, Style)))
    ).

shown_ink(hidden, shown, ink(Width,Colours,_,_,Pen,Layer), Ink) :-
    !,
    Ink = ink(Width,Colours,solid,[],Pen,Layer).
shown_ink(_, _, Ink, Ink).

%   ink(Width, Colours, Type, Runs, Pen, Layer): Width and Runs in thousandths,
%   Colours = colours(Screen,Print), Type what the style said, Runs [] if solid.

style_ink(none, none) :-
    !.
style_ink(style(Width0,Colour,Type,Pen,Layer),
          ink(Width,Colours,Type,Runs,Pen,Layer)) :-
    number(Width0),
    Width0 > 0,
    Width0 =< 100,
    Width is max(1, round(Width0*1000)),
    colours(Colour, Colours),
    type_runs(Type, Width0, Runs),
    integer(Pen),
    Pen >= 1,
    Pen =< 255,
    layer_name(Layer).

colours(colour(Screen0,Print0), colours(Screen,Print)) :-
    !,
    colour_rgb(Screen0, Screen),
    colour_rgb(Print0, Print).
colours(Colour, colours(RGB,RGB)) :-
    colour_rgb(Colour, RGB).

type_runs(solid, _, []) :-
    !.
type_runs(Type, Width, Runs) :-
    (   is_list(Type)
    ->  Runs0 = Type,
        Type = [_|_]
    ;   line_type(Type, Width, Runs0)
    ),
    !,
    length(Runs0, N),
    N mod 2 =:= 0,
    maplist(run_thousandths, Runs0, Runs).

run_thousandths(Run0, Run) :-
    number(Run0),
    Run0 > 0,
    Run0 =< 1000,
    Run is max(1, round(Run0*1000)).

paper(Rows, RGB) :-
    (   rows_paper(Rows, Colour)
    ->  true
    ;   paper_style(Colour)
    ->  true
    ;   default(paper_style(Colour))
    ),
    (   colours(Colour, colours(RGB0,_))
    ->  RGB = RGB0
    ;   decided_at(paper_style(Colour), Location),
        throw(error(model_error(style(colour(Colour))), Location))
    ).

%!  inked_lines(+Texts, +Inked, -Lines) is det.
%
%   Lines are the lines of all views, in painting order. Texts is `drawn`: the
%   letters of texts (lettering.pl) are among them; or `left`: they are not.

inked_lines(Texts, inked(_,_,Views), Lines) :-
    maplist(view_lines(Texts), Views, Own),
    append(Own, Lines).

%   Nothing is copied: a picture may have millions of points.

view_lines(left, view(_,Lines,_), Lines).
view_lines(drawn, view(_,Lines0,Written), Lines) :-
    findall(line(Ink, stroke(visible,text,0,[],Points,joint,joint)),
            ( member(text(Ink,Text), Written),
              lettering(Text, Letters),
              member(Points, Letters)
            ),
            Letters),
    append(Lines0, Letters, Lines).

%!  line_of(+Lines, -Line) is nondet.
%
%   Line, line(Ink,Stroke), is one of Lines, in order; of those with many
%   strokes each.

line_of(Lines, line(Ink,Stroke)) :-
    member(line(Ink,Strokes), Lines),
    single_strokes(Strokes, Singles),
    member(Stroke, Singles).

%!  fold_lines(:Goal, +Lines, +State0, -State) is det.
%
%   As foldl/4, of what line_of/2 has of Lines.

:- meta_predicate fold_lines(3, +, +, -).

fold_lines(Goal, Lines, State0, State) :-
    foldl(fold_line(Goal), Lines, State0, State).

fold_line(Goal, line(Ink,Strokes), State0, State) :-
    single_strokes(Strokes, Singles),
    foldl(fold_single(Goal, Ink), Singles, State0, State).

fold_single(Goal, Ink, Stroke, State0, State) :-
    call(Goal, line(Ink,Stroke), State0, State).

%!  inked_texts(+Inked, -Texts) is det.
%
%   Texts are those of all views.

inked_texts(inked(_,_,Views), Texts) :-
    findall(Text, ( member(view(_,_,Own), Views), member(Text, Own) ), Texts).

%!  inked_inks(+Inked, -Inks) is det.
%
%   Inks are those that are used, each once, in the order of their first use.

inked_inks(inked(_,_,Views), Inks) :-
    findall(Ink, view_ink(Views, Ink), Inks0),
    list_to_set(Inks0, Inks).

view_ink(Views, Ink) :-
    member(view(_,Lines,Texts), Views),
    (   changed_ink(Lines, none, Ink)
    ;   member(text(Ink,_), Texts)
    ;   member(word(Ink,_,_), Texts)
    ).

%   Each ink where another comes.

changed_ink([line(Ink0,_)|Lines], Last, Ink) :-
    (   Ink0 \== Last,
        Ink = Ink0
    ;   changed_ink(Lines, Ink0, Ink)
    ).

%!  dashes_option(+Options, +Default, -How) is det.
%
%   How dashes are written: dashes(How) of Options, where `auto` is what is
%   best in the format, Default. How is one of
%
%     - fitted: as a property of the line, fitted to it
%     - geometry: each dash is a line of its own, as cutters need it
%     - type: as a line type with a name
%
%   @error domain_error(dashes, How)

dashes_option(Options, Default, How) :-
    option(dashes(How0), Options, auto),
    (   How0 == auto
    ->  How = Default
    ;   memberchk(How0, [geometry,type])
    ->  How = How0
    ;   domain_error(dashes, How0)
    ).

%!  ink_width(+Ink, -Width) is det.
%!  ink_colour(+Medium, +Ink, -RGB) is det.
%!  ink_runs(+Ink, -Runs) is det.
%!  ink_type(+Ink, -Type) is det.
%!  ink_pen(+Ink, -Pen) is det.
%!  ink_layer(+Ink, -Layer) is det.
%
%   The parts of an ink: Width and Runs in thousandths of a millimetre, Runs
%   [] if it is solid; Medium is `screen` or `print`; Type as in a style.

ink_width(ink(Width,_,_,_,_,_), Width).

ink_colour(screen, ink(_,colours(RGB,_),_,_,_,_), RGB).
ink_colour(print, ink(_,colours(_,RGB),_,_,_,_), RGB).

ink_type(ink(_,_,Type,_,_,_), Type).

ink_runs(ink(_,_,_,Runs,_,_), Runs).

ink_pen(ink(_,_,_,_,Pen,_), Pen).

ink_layer(ink(_,_,_,_,_,Layer), Layer).

%!  ink_lines(+How, +Ink, +Stroke, -Lines) is det.
%
%   Lines are what a pen draws of Stroke, lists of points: its dashes if How is
%   `geometry` and Ink is dashed, else all of it.

ink_lines(How, Ink, Stroke, Lines) :-
    ink_runs(Ink, Runs),
    (   How == geometry,
        Runs = [_|_]
    ->  stroke_dashes(Stroke, Runs, Lines)
    ;   Stroke = stroke(_, _, _, _, Points, _, _),
        Lines = [Points]
    ).
