:- module(svg_reader,
          [ read_svg/2                  % +Text, -Document
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(sgml)).
:- use_module(library(xpath)).
:- use_module(library(yall)).
/* A reader of SVG, for tests: see drawing_reader.pl. */

%!  read_svg(+Text, -Document) is det.
%
%   Document is svg(W, H, Scale, Title, Paper, Lines, Texts), a line
%   line(View,Visibility,Role,S,Edges,Look,Runs,Offset,Points), its Look
%   look(RGB, Width, Cap) by the style block: of several rules that select it
%   the last of those for its segment, else the last.

read_svg(Text, svg(W,H,Scale,Title,Paper,Lines,Texts)) :-
    setup_call_cleanup(
        open_string(Text, In),
        load_structure(In, DOM0, [dialect(xml), max_errors(1),
                                  space(preserve)]),
        close(In)),
    include([element(_,_,_)]>>true, DOM0, DOM),
    DOM = [element(svg,Head,_)],
    memberchk(width=Width, Head),
    memberchk(height=Height, Head),
    memberchk(viewBox=Box, Head),
    maplist(in_mm, [Width,Height], [W,H]),
    atomic_list_concat(['0','0',BoxW,BoxH], ' ', Box),
    must(maplist(millionths, [BoxW,BoxH], [W,H]), view_box(Box)),
    memberchk('data-scale'=Scale0, Head),
    atom_number(Scale0, Scale),
    (   xpath(DOM, //title(text), Title)
    ->  true
    ;   Title = ''
    ),
    findall(Id, ( xpath(DOM, //(*), Element),
                  xpath(Element, /self(@id), Id) ), Ids),
    unique(Ids, ids),
    xpath_chk(DOM, //style(text), Style),
    svg_rules(Style, Rules),
    memberchk(rule(paper,[fill-Paper0]), Rules),
    hex_colour(Paper0, Paper),
    xpath_chk(DOM, //rect, Rect),
    must(( xpath(Rect, /self(@width), RW), xpath(Rect, /self(@height), RH),
           maplist(millionths, [RW,RH], [W,H]) ), rectangle),
    DOM = [element(_,_,Inside)],
    findall(Line, svg_line(Inside, '', Rules, Line), Lines),
    findall(text(X,Y,Size,Anchor,String),
            ( xpath(DOM, //text, T),
              T = element(_,_,Inner),
              atomic_list_concat(Inner, String0),
              atom_string(String0, String),
              T = element(_,Attributes,_),
              memberchk(x=X0, Attributes),
              memberchk(y=Y0, Attributes),
              memberchk('font-size'=Size0, Attributes),
              memberchk('text-anchor'=Anchor, Attributes),
              maplist(millionths, [X0,Y0,Size0], [X,Y,Size])
            ),
            Texts).

in_mm(Atom, N) :-
    atom_concat(Number, mm, Atom),
    millionths(Number, N).

millionths(Atom, N) :-
    atom_string(Atom, Text),
    split_string(Text, ".", "", Parts),
    (   Parts = [Whole]
    ->  number_of(Whole, W),
        N is W*1000
    ;   Parts = [Whole,Part],
        string_length(Part, L),
        must(L =< 3, decimals(Text)),
        must(\+ string_concat(_, "0", Part), decimals(Text)),
        string_concat(Whole, Part, Digits),
        number_of(Digits, N0),
        N is N0*10^(3-L)
    ).

svg_line(Inside, View, Rules, Line) :-
    member(element(g,Attributes,Inner), Inside),
    (   memberchk(class=view, Attributes)
    ->  memberchk(id=View1, Attributes),
        svg_line(Inner, View1, Rules, Line)
    ;   memberchk(id=Id, Attributes),
        member(element(polyline,Own,_), Inner),
        memberchk(class=Class, Own),
        atomic_list_concat([Visibility,Role], ' ', Class),
        (   View == ''
        ->  Parts = [Visibility,Role]
        ;   Parts = [View,Visibility,Role]
        ),
        must(atomic_list_concat(Parts, -, Id), group(Id, Parts)),
        svg_polyline(Own, View, Visibility, Role, Rules, Line)
    ).

svg_polyline(Own, View, Visibility, Role, Rules,
             line(View,Visibility,Role,S,Edges,Look,Runs,Offset,Points)) :-
    (   memberchk('data-segment'=S0, Own)
    ->  atom_number(S0, S)
    ;   S = 0
    ),
    (   memberchk('data-edge'=Edges0, Own)
    ->  atomic_list_concat(Edges1, ' ', Edges0),
        maplist(atom_number, Edges1, Edges)
    ;   Edges = []
    ),
    (   Edges = [E|_]
    ->  memberchk(id=Id, Own),
        format(atom(Start), 's~de~d', [S,E]),
        must(( sub_atom(Id, B, _, _, Start),
               ( View == '' -> B =:= 0 ; atom_concat(View, -, Prefix),
                                         sub_atom(Id, 0, B, _, Prefix) ) ),
             id(Id))
    ;   true
    ),
    svg_look(Rules, Visibility, Role, S, Look),
    (   memberchk(style=Style, Own)
    ->  svg_dashes(Style, Runs, Offset)
    ;   Runs = [],
        Offset = 0
    ),
    memberchk(points=Points0, Own),
    atomic_list_concat(Points1, ' ', Points0),
    maplist([A,X-Y]>>( atomic_list_concat([X0,Y0], ',', A),
                       millionths(X0, X), millionths(Y0, Y) ),
            Points1, Points).

svg_dashes(Style, Runs, Offset) :-
    split_string(Style, ";", "", [First|More]),
    string_concat("stroke-dasharray:", Runs0, First),
    words(Runs0, Runs1),
    maplist(millionths, Runs1, Runs),
    (   More = [Second],
        string_concat("stroke-dashoffset:", Offset0, Second)
    ->  millionths(Offset0, Offset)
    ;   More == [],
        Offset = 0
    ).

svg_look(Rules, Visibility, Role, S, look(RGB,Width,Cap)) :-
    findall(Properties, member(rule(line(Visibility,Role,S),Properties),
                               Rules), Own),
    findall(Properties, member(rule(line(Visibility,Role,any),Properties),
                               Rules), All),
    must(length(All, 1), rules(Visibility,Role,All)),
    append(All, Own, Both),
    last(Both, Last),
    memberchk(stroke-RGB0, Last),
    hex_colour(RGB0, RGB),
    memberchk('stroke-width'-Width0, Last),
    millionths(Width0, Width),
    (   memberchk('stroke-linecap'-butt, Last)
    ->  Cap = butt
    ;   Cap = round
    ).

%   One rule a line; those of print are another test's.

svg_rules(Style, Rules) :-
    split_string(Style, "\n", "", Lines),
    findall(rule(Selector,Properties),
            ( member(Line, Lines),
              svg_rule(Line, Selector, Properties)
            ),
            Rules).

svg_rule(Line, Selector, Properties) :-
    split_string(Line, "{}", "", [Selector0,Inside,""]),
    string_concat(".sanggwan .", Selector1, Selector0),
    split_string(Selector1, ".[]", "", Parts),
    maplist([String,Atom]>>atom_string(Atom, String), Parts, Atoms),
    (   Atoms = [Visibility,Role]
    ->  Selector = line(Visibility,Role,any)
    ;   Atoms = [Visibility,Role,Segment,'']
    ->  atomic_list_concat([_,S0,''], '"', Segment),
        atom_number(S0, S),
        Selector = line(Visibility,Role,S)
    ;   Atoms = [Selector]
    ),
    split_string(Inside, ";", "", Pairs),
    maplist([Pair,Name-Value]>>
            ( split_string(Pair, ":", "", [Name0,Value0]),
              atom_string(Name, Name0),
              atom_string(Value, Value0) ),
            Pairs, Properties).

hex_colour(Atom, rgb(R,G,B)) :-
    atom_codes(Atom, [0'#|Codes]),
    must(length(Codes, 6), colour(Atom)),
    Codes = [A,C,D,E,F,H],
    maplist([X-Y,N]>>( atom_codes(Hex, [0'0,0'x,X,Y]), atom_number(Hex, N) ),
            [A-C,D-E,F-H], [R,G,B]).
