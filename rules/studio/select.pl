:- module(sg_select,
          [ selected/3,                 % +World, +Head, -Reply
            selection_forgotten/0
          ]).
:- use_module('../store',
              [ e/5, edge_polygon/3, from_p/5, joint/6, line/9, p/3, segment/3,
                v/5 ]).
:- use_module(operand_edge, [operand_items/2]).
:- use_module(world_state, [in_state/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/3, maplist/4, partition/4]).
:- use_module(library(lists), [member/2, memberchk/2]).
/** <module> The selection of a session: what people point at, by its names.

A name is that of a picture's line or part: `s2` is segment 2, `s2e7` its edge
7, `s2p3` its polygon, `s2v5` its vertex, `s2j1` its joint, `l4` penetration
line 4. Of each the reply says what it is, which goal asks for it, what explains
it, and which other names show it, so that all panes can light it.
*/

% selected_(Names): strings, in the order in which they came.
:- dynamic selected_/1.

%!  selected(+World, +Head:dict, -Reply:dict) is det.
%
%   Head.names are selected, or, if there is no such key, what was selected is
%   told again: Reply has `selected`, a list of dicts, and `gone`, the names of
%   what was selected and is not there any more; and `ends`, where the edges
%   are that these are or that show them. With Head.keep `false` nothing is
%   selected, it is only told.
%
%   @error request_error(bad_key(names, names)), request_error(no_name(Name))

selected(World, Head, _{selected:Dicts, gone:Gone, ends:Ends}) :-
    (   get_dict(names, Head, Names)
    ->  (   is_list(Names),
            length(Names, N),
            N =< 1000,
            maplist(name_item, Names, Items)
        ->  true
        ;   request_error(bad_key(names, names))
        ),
        Gone = []
    ;   kept(Names0),
        kept_there(World, Names0, Names, Gone),
        maplist(name_item, Names, Items)
    ),
    operands(World, Items, Operands),
    in_state(World, shown,
             sg_select:told(Names, Items, Operands, Dicts, Ends)),
    (   get_dict(keep, Head, false)
    ->  true
    ;   retractall(selected_(_)),
        assertz(selected_(Names))
    ).

%   operands(World, Items, Operands): of those Items that are operands, and so
%   not drawn themselves, segment(S)-Names of what they made; of faces that an
%   operation on solids made, polygon(S, P)-Explain. Pictures know of neither.

operands(World, Items, Operands) :-
    (   ( memberchk(segment(_), Items) ; memberchk(polygon(_, _), Items) )
    ->  in_state(World, cut,
                 findall(Item-Told,
                         ( member(Item, Items), operand(Item, Told) ),
                         Operands))
    ;   Operands = []
    ).

operand(segment(S), Names) :-
    operand_items(S, Items),
    maplist(name_of, Items, Names).
operand(polygon(S, P), [piece(S, P)]) :-
    once(from_p(S, P, _, _, _)).

kept_there(World, Names0, Names, Gone) :-
    maplist(name_item, Names0, Items),
    operands(World, Items, Operands),
    in_state(World, shown,
             partition(sg_select:is_there(Operands), Names0, Names, Gone)).

kept(Names) :-
    (   selected_(Names0)
    ->  Names = Names0
    ;   Names = []
    ).

%!  selection_forgotten is det.

selection_forgotten :-
    retractall(selected_(_)).

:- public is_there/2, told/5.

is_there(Operands, Name) :-
    name_item(Name, Item),
    (   memberchk(Item-_, Operands)
    ->  true
    ;   once(item(Item, _, _, _))
    ).

%   told(Names, Items, Operands, Dicts, Ends): Ends is
%   _{s2e7:[[X,Y,Z],[X,Y,Z]], ...}; an operand has its drawn edges alone lit.

told(Names, Items, Operands, Dicts, Ends) :-
    maplist(item_dict(Operands), Names, Items, Dicts),
    findall(Name,
            ( member(Dict, Dicts),
              Dict.kind \== segment,
              ( Name = Dict.name ; member(Name, Dict.shows) ) ),
            All0),
    sort(All0, All),
    findall(Key-[[X1,Y1,Z1],[X2,Y2,Z2]],
            ( member(Name, All),
              name_item(Name, edge(S,E)),
              e(S, E, V1, V2, _),
              v(S, V1, X1, Y1, Z1),
              v(S, V2, X2, Y2, Z2),
              atom_string(Key, Name) ),
            Pairs),
    dict_pairs(Ends, _, Pairs).

%   name_item(Name, Item) is semidet: Item is segment(S), edge(S, E) ...

name_item(Name, Item) :-
    string(Name),
    string_codes(Name, Codes),
    once(phrase(name(Item), Codes)).

name(line(L)) -->
    "l",
    number(L).
name(Item) -->
    "s",
    number(S),
    part(S, Item).

part(S, segment(S)) -->
    [].
part(S, Item) -->
    [Code],
    { letter(Code, Kind) },
    sign(Sign),
    number(Id0),
    { Id is Sign*Id0,
      ( Id > 0 -> true ; Kind == edge ),
      Item =.. [Kind,S,Id] }.

letter(0'e, edge).
letter(0'p, polygon).
letter(0'v, vertex).
letter(0'j, joint).

sign(-1) -->
    "-",
    !.
sign(1) -->
    [].

number(N) -->
    [C],
    { C >= 0'1, C =< 0'9 },
    digits(Cs),
    { length(Cs, Length),
      Length < 9,
      number_codes(N, [C|Cs]) }.

digits([C|Cs]) -->
    [C],
    { C >= 0'0, C =< 0'9 },
    !,
    digits(Cs).
digits([]) -->
    [].

item_dict(Operands, Name, Item, Dict) :-
    (   item(Operands, Item, Goal, Explain, Shows)
    ->  functor(Item, Kind, _),
        format(string(GoalText), "~W", [Goal, [quoted(true),
                                               spacing(next_argument),
                                               numbervars(true)]]),
        maplist(item_text, Explain, Texts),
        Dict = _{name:Name, kind:Kind, goal:GoalText, explain:Texts,
                 shows:Shows}
    ;   request_error(no_name(Name))
    ).

item_text(Item, Text) :-
    format(string(Text), "~q", [Item]).

item(Operands, segment(S), Goal, [], Shows) :-
    memberchk(segment(S)-Shows, Operands),
    !,
    segment_goal(S, Goal).
item(Operands, Item, Goal, Explain, Shows) :-
    item(Item, Goal, Explain0, Shows),
    (   memberchk(Item-Explain1, Operands)
    ->  Explain = Explain1
    ;   Explain = Explain0
    ).

segment_goal(S, segment(S, '$VAR'('Kind'), '$VAR'('Name'))).

%   item(Item, Goal, Explain, Shows) is semidet: Explain are items of
%   `explain`, Shows names.

item(segment(S), Goal, [], []) :-
    once(segment(S, _, _)),
    segment_goal(S, Goal).
item(edge(S, E), e(S, E, '$VAR'('V1'), '$VAR'('V2'), '$VAR'('Et')), Explain,
     Shows) :-
    e(S, E, V1, V2, _),
    !,
    findall(line(L), edge_line(S, V1, V2, L), Lines),
    (   Lines == []
    ->  Explain = [hidden(S, E)]
    ;   Lines = [Line|_],
        Explain = [Line,hidden(S, E)]
    ),
    findall(Shown,
            ( member(V, [V1,V2]), name_of(vertex(S, V), Shown)
            ; edge_polygon(S, E, P), name_of(polygon(S, P), Shown)
            ; e(S, Back, V2, V1, _), name_of(edge(S, Back), Shown)
            ; member(line(L), Lines), name_of(line(L), Shown)
            ; ( joint(S, J, E, _, _, _) ; joint(S, J, _, E, _, _) ),
              name_of(joint(S, J), Shown)
            ),
            Shows0),
    sort(Shows0, Shows).
item(edge(S, E), drawn('$VAR'('D'), S, E, '$VAR'('From'), '$VAR'('To'),
                       '$VAR'('Visibility'), '$VAR'('Role')), [], []) :-
    E < 0,                              % an outline: there is one in a picture
    once(segment(S, _, _)).
item(polygon(S, P), p(S, P, '$VAR'('Es')), [], Shows) :-
    p(S, P, Es),
    findall(Shown, ( member(E, Es), E =\= 0, Id is abs(E),
                     e(S, Id, V1, V2, _),
                     ( Side = Id ; e(S, Side, V2, V1, _) ),
                     name_of(edge(S, Side), Shown) ),
            Shows0),
    sort(Shows0, Shows).
item(vertex(S, V), v(S, V, '$VAR'('X'), '$VAR'('Y'), '$VAR'('Z')),
     [vertex(S, V)], Shows) :-
    v(S, V, _, _, _),
    findall(Shown, ( ( e(S, E, V, _, _) ; e(S, E, _, V, _) ),
                     name_of(edge(S, E), Shown) ),
            Shows0),
    sort(Shows0, Shows).
item(joint(S, J), joint(S, J, '$VAR'('E1'), '$VAR'('E2'), '$VAR'('Kind'),
                        '$VAR'('Angle')), [], Shows) :-
    joint(S, J, E1, E2, _, _),
    findall(Shown, ( member(E, [E1,E2]), name_of(edge(S, E), Shown) ), Shows0),
    sort(Shows0, Shows).
item(line(L), line(L, '$VAR'('S1'), '$VAR'('P1'), '$VAR'('A1'), '$VAR'('B1'),
                   '$VAR'('S2'), '$VAR'('P2'), '$VAR'('A2'), '$VAR'('B2')),
     [line(L)], Shows) :-
    line(L, S1, _, A1, B1, S2, _, A2, B2),
    findall(Shown,
            ( member(end(S, A, B), [end(S1, A1, B1),end(S2, A2, B2)]),
              ( e(S, E, A, B, _) ; e(S, E, B, A, _) ),
              name_of(edge(S, E), Shown) ),
            Shows0),
    sort(Shows0, Shows).

edge_line(S, V1, V2, L) :-
    ( line(L, S, _, V1, V2, _, _, _, _)
    ; line(L, S, _, V2, V1, _, _, _, _)
    ; line(L, _, _, _, _, S, _, V1, V2)
    ; line(L, _, _, _, _, S, _, V2, V1)
    ).

name_of(line(L), Name) :-
    !,
    format(string(Name), "l~d", [L]).
name_of(Item, Name) :-
    Item =.. [Kind,S,Id],
    letter(Code, Kind),
    format(string(Name), "s~d~c~d", [S,Code,Id]).
