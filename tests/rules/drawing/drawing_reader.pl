:- module(drawing_reader,
          [ read_pdf/2,                 % +Text, -Document
            read_ps/2,                  % +Text, -Document
            read_dxf/2,                 % +Text, -Document
            read_lines_dxf/2,           % +Text, -Document
            read_hpgl/2,                % +Text, -Document
            read_svg/2,                 % +Text, -Document
            read_png/2,                 % +Bytes, -Document
            dashes_fit/4                % +Stroke, +Runs, +Fitted, +Offset
          ]).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(readutil)).
:- use_module(library(sgml)).
:- use_module(library(xpath)).
:- use_module(library(yall)).
:- use_module(library(zlib)).
/** <module> Readers of drawings, for tests: they share nothing with writers.

Each reads a whole file and throws wrong(What) where the file is not what its
format says: an offset, a length, a name that is not defined, a number used
twice. What they find of lines is

    path(Layer, RGB, Width, Cap, Runs, Offset, Points)

with lengths in thousandths of a millimetre, y down, as the drawing has them;
what a format does not say is `none`.
*/

must(Goal, What) :-
    (   call(Goal)
    ->  true
    ;   throw(wrong(What))
    ).

:- meta_predicate must(0, +).

unique(Keys, What) :-
    sort(Keys, Sorted),
    same_length(Keys, Sorted)
    ->  true
    ;   throw(wrong(twice(What, Keys))).

number_of(Text, Number) :-
    must(catch(number_string(Number, Text), _, fail), no_number(Text)).

words(Text, Words) :-
    split_string(Text, " \n", " \n", Words0),
    exclude(==(""), Words0, Words).

near(A, B, Least) :-
    abs(A-B) =< Least.

% --- PDF ---------------------------------------------------------------------

%!  read_pdf(+Text, -Document) is det.
%
%   Document is pdf(Title, Layers, Pages), a page page(W, H, Fills, Paths); W
%   and H in points.

read_pdf(Text, pdf(Title,Layers,Pages)) :-
    must(string_concat("%PDF-1.5\n", _, Text), header),
    must(sub_string(Text, _, 6, 0, "%%EOF\n"), end),
    sub_string(Text, B, _, _, "\nstartxref\n"),
    B1 is B+11,
    sub_string(Text, B1, _, 0, Tail),
    split_string(Tail, "\n", "", [At0|_]),
    number_of(At0, At),
    objects(Text, At, Count, Objects, TrailerAt),
    sub_string(Text, TrailerAt, _, 0, Trailer),
    must(string_concat("trailer\n<< ", _, Trailer), trailer),
    entry(Trailer, "Size", Size),
    must(number_string(Count, Size), size(Size, Count)),
    follow(Trailer, "Root", Objects, Root),
    must(entry(Root, "Type", "/Catalog"), catalogue),
    follow(Root, "Pages", Objects, PageTree),
    must(entry(PageTree, "Type", "/Pages"), pages),
    list_of(PageTree, "Kids", Kids),
    length(Kids, PageCount),
    must(( entry(PageTree, "Count", C), number_string(PageCount, C) ), count),
    unique(Kids, kids),
    list_of(Root, "OCGs", Groups),
    list_of(Root, "Order", Order),
    must(Groups == Order, order),
    unique(Groups, layers),
    maplist(layer_name(Objects), Groups, Layers),
    unique(Layers, layer_names),
    follow(Trailer, "Info", Objects, Info),
    must(sub_string(Info, _, _, _, "/Producer (Sanggwan)"), producer),
    entry(Info, "Title", Title),
    maplist(pdf_page(Objects, Root, Layers), Kids, Pages),
    Made is 3*PageCount+3,
    length(Groups, LayerCount),
    must(Count =:= Made+LayerCount+1, objects(Count)).

%   objects(Text, At, Count, Objects, End): N-Object for each number of the
%   table of cross references at At.

objects(Text, At, Count, Objects, End) :-
    sub_string(Text, At, _, 0, Table),
    must(string_concat("xref\n0 ", Table1, Table), xref(At)),
    split_string(Table1, "\n", "", [Count0|_]),
    number_of(Count0, Count),
    string_length(Count0, Digits),
    First is At+8+Digits,
    sub_string(Text, First, 20, _, Free),
    must(Free == "0000000000 65535 f \n", free),
    Last is Count-1,
    findall(N-Object,
            ( between(1, Last, N),
              From is First+20*N,
              sub_string(Text, From, 20, _, Row),
              must(sub_string(Row, 10, 10, 0, " 00000 n \n"), row(N)),
              sub_string(Row, 0, 10, _, Offset0),
              number_of(Offset0, Offset),
              sub_string(Text, Offset, _, 0, Rest),
              format(string(Head), "~d 0 obj\n", [N]),
              must(string_concat(Head, Body, Rest), offset(N)),
              must(once(sub_string(Body, Length, _, _, "\nendobj\n")),
                   endobj(N)),
              sub_string(Body, 0, Length, _, Object)
            ),
            Objects),
    aggregate_all(count, sub_string(Text, _, _, _, "\nendobj\n"), Written),
    must(Written =:= Last, unlisted(Written)),
    End is First+20*Count.

%   entry(Object, Name, Value): the value of a key of a dictionary.

entry(Object, Name, Value) :-
    format(string(Key), "/~w ", [Name]),
    must(once(sub_string(Object, B, _, _, Key)), no(Name)),
    string_length(Key, Length),
    From is B+Length,
    sub_string(Object, From, _, 0, Rest),
    (   string_concat("[", List, Rest)
    ->  once(sub_string(List, L, _, _, "]")),
        sub_string(List, 0, L, _, Value)
    ;   split_string(Rest, " \n", "", [Value|_])
    ).

reference(Object, Name, N) :-
    entry(Object, Name, N0),
    format(string(Whole), "/~w ~w 0 R", [Name,N0]),
    must(sub_string(Object, _, _, _, Whole), no_reference(Name)),
    number_of(N0, N).

follow(Object, Name, Objects, Found) :-
    reference(Object, Name, N),
    must(memberchk(N-Found, Objects), no_object(N)).

list_of(Object, Name, Numbers) :-
    entry(Object, Name, Text),
    words(Text, Words),
    references(Words, Numbers).

references([], []).
references([N0,"0","R"|Words], [N|Ns]) :-
    number_of(N0, N),
    references(Words, Ns).

layer_name(Objects, N, Name) :-
    must(memberchk(N-Object, Objects), no_layer(N)),
    must(entry(Object, "Type", "/OCG"), no_group(N)),
    entry(Object, "Name", Name0),
    string_concat("(", Name1, Name0),
    string_concat(Name, ")", Name1).

pdf_page(Objects, Root, Layers, N, page(W,H,Fills,Paths)) :-
    must(memberchk(N-Page, Objects), no_page(N)),
    must(entry(Page, "Type", "/Page"), page_type(N)),
    reference(Root, "Pages", Tree),
    must(reference(Page, "Parent", Tree), parent(N)),
    entry(Page, "MediaBox", Box),
    words(Box, ["0","0",W0,H0]),
    maplist(number_of, [W0,H0], [W,H]),
    entry(Page, "Properties", _),
    findall(Label-Layer,
            ( nth0(I, Layers, Layer),
              list_of(Root, "OCGs", Groups),
              nth0(I, Groups, Group),
              format(string(Property), "/L~d ~d 0 R", [I,Group]),
              must(sub_string(Page, _, _, _, Property), property(I)),
              format(string(Label), "/L~d", [I])
            ),
            Labels),
    follow(Page, "Contents", Objects, Content),
    follow(Content, "Length", Objects, Length0),
    must(once(sub_string(Content, B, _, _, " >>\nstream\n")), stream),
    From is B+11,
    number_of(Length0, Length),
    must(sub_string(Content, From, Length, After, Stream), length(Length)),
    must(After =:= 9, length(Length)),
    must(sub_string(Content, _, 9, 0, "endstream"), endstream),
    painted(Stream, pdf, [], H, Labels, Fills, Paths).

% --- PostScript --------------------------------------------------------------

%!  read_ps(+Text, -Document) is det.
%
%   Document is ps(Kind, Title, Page).

read_ps(Text, ps(Kind,Title,page(W,H,Fills,Paths))) :-
    split_string(Text, "\n", "", Lines),
    must(append([First,Box,HighBox,TitleLine,"%%Creator: Sanggwan",
                 "%%LanguageLevel: 2","%%Pages: 1","%%EndComments",
                 "%%BeginProlog"], Rest, Lines), comments),
    must(kind(First, Kind), kind(First)),
    must(string_concat("%%BoundingBox: 0 0 ", Box1, Box), box),
    must(string_concat("%%HiResBoundingBox: 0 0 ", HighBox1, HighBox), box),
    words(Box1, Whole0),
    words(HighBox1, High0),
    maplist(number_of, Whole0, Whole),
    maplist(number_of, High0, [W,H]),
    must(maplist([A,B]>>( integer(A), A >= B-0.001, A-1 < B ), Whole, [W,H]),
         box(Whole, W, H)),
    must(string_concat("%%Title: ", Title, TitleLine), title),
    append(Defined, ["%%EndProlog"|Body0], Rest),
    !,
    maplist(definition, Defined, Defs),
    pairs_keys(Defs, Names),
    unique(Names, operators),
    (   Kind == ps
    ->  format(string(Size), "<< /PageSize [~3f ~3f] >> setpagedevice", [W,H]),
        must(append(["%%BeginSetup",Size,"%%EndSetup"], Body1, Body0), Size)
    ;   Body1 = Body0
    ),
    must(append(["%%Page: 1 1","gsave"], Body2, Body1), page),
    must(append(Body, ["grestore","showpage","%%EOF",""], Body2), end),
    atomic_list_concat(Body, '\n', Content),
    painted(Content, ps, Defs, H, [], Fills, Paths).

kind("%!PS-Adobe-3.0", ps).
kind("%!PS-Adobe-3.0 EPSF-3.0", eps).

definition(Line, Name-Words) :-
    must(string_concat("/", Rest, Line), definition(Line)),
    must(once(sub_string(Rest, B, 1, _, "{")), definition(Line)),
    sub_string(Rest, 0, B, _, Name),
    must(sub_string(Rest, _, _, 0, "}bind def"), definition(Line)),
    From is B+1,
    string_length(Rest, Length),
    Inner is Length-From-9,
    sub_string(Rest, From, Inner, _, Body),
    words(Body, Words).

% --- the machine of both -----------------------------------------------------

%   painted(Content, Kind, Defs, H, Labels, Fills, Paths): what a page of
%   height H shows; operators are those of PDF, or of PostScript with Defs.

painted(Content, Kind, Defs, H, Labels, Fills, Paths) :-
    split_string(Content, "", "", [Text0]),
    spaced(Text0, Text),
    words(Text, Words),
    State = machine{ stack: [], matrix: [1,0,0,1,0,0], rgb: [0,0,0],
                     fill: [0,0,0], width: 1, cap: 0, join: 0, dash: [],
                     offset: 0, layer: none, path: [], out: [], fills: [],
                     how: how(Kind,Defs,Labels), height: H },
    run(Words, State, End),
    must(End.stack == [], left(End.stack)),
    must(End.path == [], unpainted),
    must(End.layer == none, open_layer),
    reverse(End.out, Paths),
    reverse(End.fills, Fills).

spaced(Text0, Text) :-
    split_string(Text0, "[", "", As),
    atomic_list_concat(As, ' [ ', Text1),
    split_string(Text1, "]", "", Bs),
    atomic_list_concat(Bs, ' ] ', Text).

run([], State, State).
run([Word|Words], State0, State) :-
    (   number_string(Number, Word)
    ->  State1 = State0.put(stack, [Number|State0.stack]),
        Words1 = Words
    ;   sub_string(Word, 0, 1, _, "/")
    ->  State1 = State0.put(stack, [Word|State0.stack]),
        Words1 = Words
    ;   Word == "["
    ->  append(Inside0, ["]"|Words1], Words),
        !,
        maplist(number_of, Inside0, Inside),
        State1 = State0.put(stack, [array(Inside)|State0.stack])
    ;   State0.how = how(ps,Defs,_),
        memberchk(Word-Body, Defs)
    ->  append(Body, Words, Words1),
        State1 = State0
    ;   State0.how = how(Kind,_,_),
        operator(Kind, Word, Stack, Stack1, State0, Changed)
    ->  must(append(_, Stack1, State0.stack), stack(Word)),
        must(Stack = State0.stack, stack(Word, State0.stack)),
        State1 = Changed,
        Words1 = Words
    ;   throw(wrong(operator(Word)))
    ),
    !,
    run(Words1, State1, State).

%   operator(Kind, Word, Before, After, State0, State): Before is the stack.

operator(pdf, Word, Stack, _, State0, State) :-
    pdf_operator(Word, Name),
    !,
    Stack = State0.stack,
    act(Name, State0, State).
operator(ps, Word, Stack, _, State0, State) :-
    Stack = State0.stack,
    atom_string(Name, Word),
    act(Name, State0, State).

pdf_operator("cm", cm).
pdf_operator("m", moveto).
pdf_operator("l", lineto).
pdf_operator("h", closepath).
pdf_operator("S", stroke).
pdf_operator("w", setlinewidth).
pdf_operator("J", setlinecap).
pdf_operator("j", setlinejoin).
pdf_operator("d", setdash).
pdf_operator("RG", setrgbcolor).
pdf_operator("rg", setfill).
pdf_operator("re", re).
pdf_operator("f", fill).
pdf_operator("BDC", begin_layer).
pdf_operator("EMC", end_layer).

act(cm, S0, S) :-
    S0.stack = [F,E,D,C,B,A|Stack],
    multiply([A,B,C,D,E,F], S0.matrix, M),
    S = S0.put(_{stack:Stack, matrix:M}).
act(array, S0, S) :-
    S0.stack = [N|Stack],
    S = S0.put(stack, [room(N)|Stack]).
act(astore, S0, S) :-
    S0.stack = [room(N)|Stack0],
    length(Last, N),
    append(Last, Stack, Stack0),
    reverse(Last, Array),
    S = S0.put(stack, [array(Array)|Stack]).
act(concat, S0, S) :-
    S0.stack = [array(A)|Stack],
    multiply(A, S0.matrix, M),
    S = S0.put(_{stack:Stack, matrix:M}).
act(pop, S0, S) :-
    S0.stack = [_|Stack],
    S = S0.put(stack, Stack).
act(dup, S0, S) :-
    S0.stack = [A|Stack],
    S = S0.put(stack, [A,A|Stack]).
act(exch, S0, S) :-
    S0.stack = [B,A|Stack],
    S = S0.put(stack, [A,B|Stack]).
act(neg, S0, S) :-
    S0.stack = [A|Stack],
    B is -A,
    S = S0.put(stack, [B|Stack]).
act(roll, S0, S) :-
    S0.stack = [J,N|Stack0],
    length(Top, N),
    append(Top, Stack, Stack0),
    Turn is J mod N,
    length(Moved, Turn),
    append(Moved, Left, Top),
    append([Left,Moved,Stack], Stack1),
    S = S0.put(stack, Stack1).
act(moveto, S0, S) :-
    S0.stack = [Y,X|Stack],
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y])|S0.path]}).
act(lineto, S0, S) :-
    S0.stack = [Y,X|Stack],
    S0.path = [sub(open,Points)|Path],
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y|Points])|Path]}).
act(rlineto, S0, S) :-
    S0.stack = [DY,DX|Stack],
    S0.path = [sub(open,[X0-Y0|Points])|Path],
    X is X0+DX,
    Y is Y0+DY,
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y,X0-Y0|Points])|Path]}).
act(re, S0, S) :-
    S0.stack = [H,W,Y,X|Stack],
    X1 is X+W,
    Y1 is Y+H,
    S = S0.put(_{ stack:Stack,
                  path:[sub(closed,[X-Y,X1-Y,X1-Y1,X-Y1,X-Y])|S0.path] }).
act(closepath, S0, S) :-
    S0.path = [sub(open,Points)|Path],
    last(Points, First),
    S = S0.put(path, [sub(closed,[First|Points])|Path]).
act(stroke, S0, S) :-
    must(S0.join =:= 1, join),
    reverse(S0.path, Subs),
    must(Subs = [_], subpaths),
    findall(path(S0.layer,S0.rgb,Width,S0.cap,S0.dash,S0.offset,Points),
            ( member(sub(_,Back), Subs),
              placed_width(S0, Width),
              placed(S0, Back, Points)
            ),
            New),
    reverse(New, Last),
    append(Last, S0.out, Out),
    S = S0.put(_{path:[], out:Out}).
act(fill, S0, S) :-
    findall(fill(S0.fill,Points),
            ( member(sub(closed,Back), S0.path), placed(S0, Back, Points) ),
            New),
    append(New, S0.fills, Fills),
    S = S0.put(_{path:[], fills:Fills}).
act(setlinewidth, S0, S) :-
    S0.stack = [W|Stack],
    S = S0.put(_{stack:Stack, width:W}).
act(setlinecap, S0, S) :-
    S0.stack = [C|Stack],
    S = S0.put(_{stack:Stack, cap:C}).
act(setlinejoin, S0, S) :-
    S0.stack = [J|Stack],
    S = S0.put(_{stack:Stack, join:J}).
act(setdash, S0, S) :-
    S0.stack = [Offset,array(Runs)|Stack],
    S = S0.put(_{stack:Stack, dash:Runs, offset:Offset}).
act(setrgbcolor, S0, S) :-
    S0.stack = [B,G,R|Stack],
    S = S0.put(_{stack:Stack, rgb:[R,G,B], fill:[R,G,B]}).
act(setfill, S0, S) :-
    S0.stack = [B,G,R|Stack],
    S = S0.put(_{stack:Stack, fill:[R,G,B]}).
act(begin_layer, S0, S) :-
    S0.stack = [Label,"/OC"|Stack],
    S0.how = how(_,_,Labels),
    must(S0.layer == none, nested_layer),
    must(memberchk(Label-Layer, Labels), no_layer(Label)),
    S = S0.put(_{stack:Stack, layer:Layer}).
act(end_layer, S0, S) :-
    must(S0.layer \== none, no_open_layer),
    S = S0.put(layer, none).

multiply([A,B,C,D,E,F], [G,H,I,J,K,L], [M,N,O,P,Q,R]) :-
    M is A*G+B*I,
    N is A*H+B*J,
    O is C*G+D*I,
    P is C*H+D*J,
    Q is E*G+F*I+K,
    R is E*H+F*J+L.

placed_width(S, Width) :-
    S.matrix = [A,B,C,D,_,_],
    Width is round(S.width*sqrt(abs(A*D-B*C))*25400/72).

placed(S, Back, Points) :-
    S.matrix = [A,B,C,D,E,F],
    reverse(Back, Own),
    H = S.height,
    findall(X-Y,
            ( member(X0-Y0, Own),
              X is round((A*X0+C*Y0+E)*25400/72),
              Y is round((H-(B*X0+D*Y0+F))*25400/72)
            ),
            Points).

% --- DXF ---------------------------------------------------------------------

%!  read_dxf(+Text, -Document) is det.
%
%   Document is dxf(Header, Types, Layers, Entities): Name-Groups of each
%   variable; type(Name,Runs); layer(Name,Colour,Type);
%   line(Layer,Colour,Runs,Closed,Vertices) with vertices X-Y-Data in
%   thousandths,
%   y up; text(Layer,Colour,X-Y,Height,Place,Text).

read_dxf(Text, dxf(Header,Types,Layers,Entities)) :-
    split_string(Text, "\n", "", Lines),
    dxf_groups(Lines, Groups),
    must(last(Groups, 0-"EOF"), eof),
    dxf_section("HEADER", Groups, Groups1, HeaderGroups),
    dxf_section("TABLES", Groups1, Groups2, TableGroups),
    dxf_section("ENTITIES", Groups2, [0-"EOF"], EntityGroups),
    variables(HeaderGroups, Header),
    dxf_tables(TableGroups, Tables),
    memberchk("LTYPE"-Types0, Tables),
    memberchk("LAYER"-Layers0, Tables),
    must(memberchk("APPID"-[["SANGGWAN"-_]], Tables), appid),
    maplist(dxf_type, Types0, Types),
    maplist(dxf_layer, Layers0, Layers),
    findall(Name, member(type(Name,_), Types), TypeNames),
    findall(Name, member(layer(Name,_,_), Layers), LayerNames),
    unique(TypeNames, types),
    unique(LayerNames, layers),
    must(memberchk("CONTINUOUS", TypeNames), continuous),
    must(memberchk("0", LayerNames), layer_0),
    forall(member(layer(Name,Colour,Type), Layers),
           ( must(memberchk(Type, TypeNames), no_type(Name,Type)),
             must(between(1, 255, Colour), colour(Name,Colour)) )),
    dxf_entities(EntityGroups, tables(Types,Layers), Entities).

%!  read_lines_dxf(+Text, -Document) is det.
%
%   Document is lines(Low, High, Entities): lines in space,
%   line(Layer,Colour,Closed,Numbers,Points), Points X-Y-Z-Numbers, Numbers
%   those of extended data; a POINT is one of one point.

read_lines_dxf(Text, lines(Low,High,Entities)) :-
    split_string(Text, "\n", "", Lines),
    dxf_groups(Lines, Groups),
    dxf_section("HEADER", Groups, Groups1, HeaderGroups),
    dxf_section("TABLES", Groups1, Groups2, TableGroups),
    dxf_section("ENTITIES", Groups2, [0-"EOF"], EntityGroups),
    variables(HeaderGroups, Header),
    must(memberchk("$ACADVER"-[1-"AC1009"], Header), version),
    memberchk("$EXTMIN"-LowGroups, Header),
    memberchk("$EXTMAX"-HighGroups, Header),
    dxf_place(LowGroups, Low, []),
    dxf_place(HighGroups, High, []),
    dxf_tables(TableGroups, Tables),
    must(memberchk("LTYPE"-[["CONTINUOUS"-Type]], Tables), type),
    dxf_type(["CONTINUOUS"-Type], type(_,[])),
    must(memberchk("APPID"-[["SANGGWAN"-[70-"0"]]], Tables), appid),
    memberchk("LAYER"-Layers0, Tables),
    maplist(dxf_layer, Layers0, Layers),
    findall(Name, member(layer(Name,_,_), Layers), Names),
    unique(Names, layers),
    must(memberchk("0", Names), layer_0),
    forall(member(layer(Name,_,OwnType), Layers),
           must(OwnType == "CONTINUOUS", no_type(Name))),
    line_entities(EntityGroups, Layers, Entities).

dxf_place([10-X0,20-Y0,30-Z0|Rest], X-Y-Z, Rest) :-
    maplist(number_of, [X0,Y0,Z0], [X,Y,Z]).

line_entities([], _, []).
line_entities([0-"POINT",8-Layer|Groups], Layers,
              [line(Layer,Colour,point,Numbers,[Place-[]])|Entities]) :-
    !,
    must(memberchk(layer(Layer,Colour,_), Layers), no_layer(Layer)),
    dxf_place(Groups, Place, Groups1),
    extended(Groups1, Numbers, Rest),
    line_entities(Rest, Layers, Entities).
line_entities([0-"POLYLINE",8-Layer,66-"1"|Groups], Layers,
              [line(Layer,Colour,Closed,Numbers,Points)|Entities]) :-
    must(memberchk(layer(Layer,Colour,_), Layers), no_layer(Layer)),
    dxf_place(Groups, Zero, [70-Flags0|Groups1]),
    must(Zero =@= 0.0-0.0-0.0, elevation),
    number_of(Flags0, Flags),
    must(memberchk(Flags-Closed, [8-open,9-closed]), flags(Flags)),
    extended(Groups1, Numbers, Groups2),
    space_vertices(Groups2, Layer, Points, [0-"SEQEND",8-Layer|Rest]),
    !,
    line_entities(Rest, Layers, Entities).
line_entities([Group|_], _, _) :-
    throw(wrong(entity(Group))).

extended([1001-"SANGGWAN"|Groups], Numbers, Rest) :-
    extended_numbers(Groups, Numbers, Rest).

extended_numbers([1071-N0|Groups], [N|Ns], Rest) :-
    !,
    number_of(N0, N),
    extended_numbers(Groups, Ns, Rest).
extended_numbers(Rest, [], Rest).

space_vertices([0-"VERTEX",8-Layer|Groups], Layer, [Place-Numbers|Points],
               Rest) :-
    !,
    dxf_place(Groups, Place, [70-"32"|Groups1]),
    extended(Groups1, Numbers, Groups2),
    space_vertices(Groups2, Layer, Points, Rest).
space_vertices(Rest, _, [], Rest).

dxf_groups([""], []) :-
    !.
dxf_groups([Code0,Value|Lines], [Code-Value|Groups]) :-
    must(( string_length(Code0, L), memberchk(L, [3,4]) ), code(Code0)),
    normalize_space(string(Code1), Code0),
    number_of(Code1, Code),
    dxf_groups(Lines, Groups).

dxf_section(Name, [0-"SECTION",2-Name|Groups], Rest, Inside) :-
    must(append(Inside, [0-"ENDSEC"|Rest], Groups), endsec(Name)),
    !.
dxf_section(Name, _, _, _) :-
    throw(wrong(section(Name))).

variables([], []).
variables([9-Name|Groups], [Name-Own|Variables]) :-
    append(Own, Rest, Groups),
    ( Rest = [9-_|_] ; Rest == [] ),
    !,
    variables(Rest, Variables).

dxf_tables([], []).
dxf_tables([0-"TABLE",2-Name,70-Count0|Groups], [Name-Entries|Tables]) :-
    must(append(Inside, [0-"ENDTAB"|Rest], Groups), endtab(Name)),
    !,
    dxf_entries(Inside, Name, Entries),
    length(Entries, Count),
    must(number_string(Count, Count0), table_count(Name,Count0,Count)),
    dxf_tables(Rest, Tables).

dxf_entries([], _, []).
dxf_entries([0-Kind,2-Name|Groups], Kind, [[Name-Own]|Entries]) :-
    append(Own, Rest, Groups),
    ( Rest = [0-_|_] ; Rest == [] ),
    !,
    dxf_entries(Rest, Kind, Entries).

dxf_type([Name-Groups], type(Name,Runs)) :-
    must(Groups = [70-"0",3-_,72-"65",73-N0,40-Length0|Rest], type(Name)),
    maplist([49-Text,Run]>>thousandths(Text, Run), Rest, Runs),
    length(Runs, N),
    must(number_string(N, N0), type_count(Name)),
    foldl([Run,L0,L]>>( L is L0+abs(Run) ), Runs, 0, Length),
    must(thousandths(Length0, Length), type_length(Name)).

dxf_layer([Name-[70-"0",62-Colour0,6-Type]], layer(Name,Colour,Type)) :-
    number_of(Colour0, Colour).

%   Three decimals, exactly.

thousandths(Text, N) :-
    must(( split_string(Text, ".", "", [Whole,Part]),
           string_length(Part, 3) ), decimal(Text)),
    string_concat(Whole, Part, Digits),
    number_of(Digits, N).

dxf_entities([], _, []).
dxf_entities([0-"POLYLINE",8-Layer|Groups], Tables,
             [line(Layer,Colour,Runs,Closed,Vertices)|Entities]) :-
    !,
    dxf_look(Groups, Layer, Tables, Colour, Runs, Groups1),
    must(append([66-"1",10-"0.000",20-"0.000",30-"0.000",70-Flags0], Rest,
                Groups1), polyline),
    number_of(Flags0, Flags),
    must(memberchk(Flags-Closed, [128-open,129-closed]), flags(Flags)),
    dxf_vertices(Rest, Layer, Vertices, Rest1),
    must(append([0-"SEQEND",8-Layer], Rest2, Rest1), seqend),
    dxf_entities(Rest2, Tables, Entities).
dxf_entities([0-"TEXT",8-Layer|Groups], Tables,
             [text(Layer,Colour,X-Y,Height,Place,Text)|Entities]) :-
    dxf_look(Groups, Layer, Tables, Colour, _, Groups1),
    must(append([10-X0,20-Y0,30-"0.000",40-Height0,1-Text], Rest0, Groups1),
         text),
    maplist(thousandths, [X0,Y0,Height0], [X,Y,Height]),
    (   append([72-Place0,11-X1,21-Y1,31-"0.000"], Rest, Rest0)
    ->  number_of(Place0, Place),
        must(X1-Y1 == X0-Y0, second_place)
    ;   Place = 0,
        Rest = Rest0
    ),
    dxf_entities(Rest, Tables, Entities).

dxf_look(Groups0, Layer, tables(Types,Layers), Colour, Runs, Groups) :-
    must(memberchk(layer(Layer,LayerColour,LayerType), Layers),
         no_layer(Layer)),
    (   Groups0 = [62-Colour0|Groups1]
    ->  number_of(Colour0, Colour)
    ;   Colour = LayerColour,
        Groups1 = Groups0
    ),
    (   Groups1 = [6-Type|Groups]
    ->  true
    ;   Type = LayerType,
        Groups = Groups1
    ),
    must(memberchk(type(Type,Runs), Types), no_type(Type)).

dxf_vertices([0-"VERTEX",8-Layer,10-X0,20-Y0,30-"0.000"|Groups], Layer,
             [X-Y-Data|Vertices], Rest) :-
    !,
    maplist(thousandths, [X0,Y0], [X,Y]),
    (   Groups = [1001-"SANGGWAN",1071-S0,1071-E0|Groups1]
    ->  maplist(number_of, [S0,E0], [S,E]),
        Data = S-E
    ;   Data = none,
        Groups1 = Groups
    ),
    dxf_vertices(Groups1, Layer, Vertices, Rest).
dxf_vertices(Rest, _, [], Rest).

% --- HPGL --------------------------------------------------------------------

%!  read_hpgl(+Text, -Document) is det.
%
%   Document is hpgl(Corner, Pens, Pieces): Corner X-Y of IP or none, the pens
%   in order, and piece(Pen, Type, Comment, A, B) of each straight line drawn,
%   in units; Type is solid or type(N,Percent).

read_hpgl(Text, hpgl(Corner,Pens,Pieces)) :-
    split_string(Text, "\n", "", Lines0),
    must(append(["IN;"|Lines], ["PU;SP0;",""], Lines0), frame),
    (   Lines = [First|Lines1],
        string_concat("IP0,0,", Rest, First)
    ->  string_concat(Numbers, ";", Rest),
        hpgl_points(Numbers, [Corner])
    ;   Lines1 = Lines,
        Corner = none
    ),
    foldl(hpgl_line, Lines1, pen(none,up,none,solid,none,[],[]),
          pen(_,_,_,Type,_,Pens0,Pieces0)),
    must(Type == solid, line_type_left(Type)),
    reverse(Pens0, Pens),
    unique(Pens, pens),
    reverse(Pieces0, Pieces).

hpgl_line(Line, pen(Pen0,Down0,At0,Type0,Comment0,Pens0,Pieces0), State) :-
    (   string_concat("PU;SP", Rest, Line)
    ->  string_concat(N, ";", Rest),
        number_of(N, Pen),
        State = pen(Pen,up,At0,Type0,none,[Pen|Pens0],Pieces0)
    ;   string_concat("CO \"", Rest, Line)
    ->  must(string_concat(Comment, "\";", Rest), comment(Line)),
        State = pen(Pen0,Down0,At0,Type0,Comment,Pens0,Pieces0)
    ;   Line == "LT;"
    ->  State = pen(Pen0,Down0,At0,solid,Comment0,Pens0,Pieces0)
    ;   string_concat("LT", Rest, Line)
    ->  string_concat(Numbers, ";", Rest),
        split_string(Numbers, ",", "", Words),
        maplist(number_of, Words, [N,Percent]),
        State = pen(Pen0,Down0,At0,type(N,Percent),Comment0,Pens0,Pieces0)
    ;   split_string(Line, ";", "", Parts0),
        must(append(Parts, [""], Parts0), semicolon(Line)),
        foldl(hpgl_move, Parts,
              pen(Pen0,Down0,At0,Type0,Comment0,Pens0,Pieces0), State)
    ).

hpgl_move(Part, pen(Pen,_,_,Type,Comment,Pens,Pieces),
          pen(Pen,up,At,Type,Comment,Pens,Pieces)) :-
    string_concat("PU", Numbers, Part),
    !,
    hpgl_points(Numbers, Points),
    last(Points, At).
hpgl_move(Part, pen(Pen,_,At0,Type,Comment,Pens,Pieces0),
          pen(Pen,down,At,Type,Comment,Pens,Pieces)) :-
    must(string_concat("PD", Numbers, Part), instruction(Part)),
    must(Pen \== none, no_pen),
    hpgl_points(Numbers, Points),
    foldl(hpgl_piece(Pen, Type, Comment), Points, At0-Pieces0, At-Pieces).

hpgl_piece(Pen, Type, Comment, B, A-Pieces,
           B-[piece(Pen,Type,Comment,A,B)|Pieces]).

hpgl_points(Text, Points) :-
    split_string(Text, ",", "", Words),
    maplist(number_of, Words, Numbers),
    must(maplist(integer, Numbers), integers(Text)),
    hpgl_pairs(Numbers, Points).

hpgl_pairs([], []).
hpgl_pairs([X,Y|Numbers], [X-Y|Points]) :-
    hpgl_pairs(Numbers, Points).

% --- SVG ---------------------------------------------------------------------

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

% --- PNG ---------------------------------------------------------------------

%!  read_png(+Bytes, -Document) is det.
%
%   Document is png(W, H, Depth, Colour, Chunks, Rows): Chunks Type-Data of
%   those beside IHDR, IDAT, IEND; Rows lists of bytes, unfiltered.

read_png(Bytes, png(W,H,Depth,Colour,Chunks,Rows)) :-
    must(append([137,80,78,71,13,10,26,10], Rest, Bytes), signature),
    png_chunks(Rest, All),
    must(All = ["IHDR"-Head|_], ihdr),
    must(last(All, "IEND"-[]), iend),
    Head = [W3,W2,W1,W0,H3,H2,H1,H0,Depth,Colour,Method,Filter,Interlace],
    must([Method,Filter,Interlace] == [0,0,0], methods),
    W is W3<<24 \/ W2<<16 \/ W1<<8 \/ W0,
    H is H3<<24 \/ H2<<16 \/ H1<<8 \/ H0,
    findall(Part, member("IDAT"-Part, All), Parts),
    append(Parts, Packed),
    findall(Type-Data, ( member(Type-Data, All),
                         \+ memberchk(Type, ["IHDR","IDAT","IEND"]) ), Chunks),
    unpacked(Packed, Bits),
    must(memberchk(Colour-Channels, [0-1,2-3,3-1]), colour(Colour)),
    Length is (W*Channels*Depth+7)//8,
    Step is max(1, Channels*Depth//8),
    png_rows(Bits, H, Length, Step, Rows).

png_chunks([], []).
png_chunks([L3,L2,L1,L0|Rest], [Type-Data|Chunks]) :-
    Length is L3<<24 \/ L2<<16 \/ L1<<8 \/ L0,
    Both is Length+4,
    length(Checked, Both),
    must(append(Checked, [C3,C2,C1,C0|Rest1], Rest), chunk),
    crc32(Checked, CRC),
    must(CRC =:= C3<<24 \/ C2<<16 \/ C1<<8 \/ C0, crc),
    length(Name, 4),
    append(Name, Data, Checked),
    string_codes(Type, Name),
    png_chunks(Rest1, Chunks).

crc32(Bytes, CRC) :-
    foldl(crc_byte, Bytes, 0xFFFFFFFF, Last),
    CRC is Last xor 0xFFFFFFFF.

crc_byte(Byte, C0, C) :-
    C1 is C0 xor Byte,
    crc_bits(8, C1, C).

crc_bits(0, C, C) :-
    !.
crc_bits(N, C0, C) :-
    (   C0 /\ 1 =:= 1
    ->  C1 is (C0 >> 1) xor 0xEDB88320
    ;   C1 is C0 >> 1
    ),
    N1 is N-1,
    crc_bits(N1, C1, C).

unpacked(Packed, Bytes) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary)]),
        ( format(Out, '~s', [Packed]),
          close(Out),
          setup_call_cleanup(
              ( open(File, read, In, [type(binary)]),
                zopen(In, Inflated, [format(deflate)]) ),
              read_stream_to_codes(Inflated, Bytes),
              close(Inflated))
        ),
        delete_file(File)).

png_rows(Bits, H, Length, Step, Rows) :-
    length(Zeros, Length),
    maplist(=(0), Zeros),
    png_rows(H, Bits, Length, Step, Zeros, Rows).

png_rows(0, Bits, _, _, _, []) :-
    !,
    must(Bits == [], rows).
png_rows(N, [Filter|Bits], Length, Step, Above, [Row|Rows]) :-
    length(Raw, Length),
    must(append(Raw, Rest, Bits), row(N)),
    unfiltered(Filter, Raw, Above, Step, Row),
    N1 is N-1,
    png_rows(N1, Rest, Length, Step, Row, Rows).

unfiltered(0, Row, _, _, Row) :-
    !.
unfiltered(Filter, Raw, Above, Step, Row) :-
    must(between(1, 4, Filter), filter(Filter)),
    length(Zeros, Step),
    maplist(=(0), Zeros),
    append(Zeros, Row, Lefts),
    append(Zeros, Above, Corners),
    unfiltered_(Raw, Above, Lefts, Corners, Filter, Row).

unfiltered_([], _, _, _, _, []).
unfiltered_([X|Raw], [B|Bs], [A|As], [C|Cs], Filter, [Y|Row]) :-
    guess(Filter, A, B, C, G),
    Y is (X+G) /\ 255,
    unfiltered_(Raw, Bs, As, Cs, Filter, Row).

guess(1, A, _, _, A).
guess(2, _, B, _, B).
guess(3, A, B, _, G) :-
    G is (A+B)//2.
guess(4, A, B, C, G) :-
    P is A+B-C,
    PA is abs(P-A),
    PB is abs(P-B),
    PC is abs(P-C),
    (   PA =< PB,
        PA =< PC
    ->  G = A
    ;   PB =< PC
    ->  G = B
    ;   G = C
    ).

% --- dashes ------------------------------------------------------------------

%!  dashes_fit(+Stroke, +Runs, +Fitted, +Offset) is semidet.
%
%   True when Fitted are Runs, all longer or shorter alike, and the line begins
%   and ends with a whole dash, or with a gap where it is cut; the number of
%   periods is the one that changes them least.

dashes_fit(stroke(_,_,_,_,Points,Start,End), Runs, Fitted, Offset) :-
    same_length(Runs, Fitted),
    way(Points, Length),
    sum_list(Runs, Period0),
    sum_list(Fitted, Period),
    Fitted = [Dash|_],
    last(Fitted, LastGap),
    Fitted = [_,Gap|_],
    (   Start == cut
    ->  Offset =:= Period-LastGap,
        Before = LastGap
    ;   Offset =:= 0,
        Before = 0
    ),
    (   Start == ring
    ->  Ends = 0
    ;   End == cut
    ->  Ends is Before+Dash+Gap
    ;   Ends is Before+Dash
    ),
    N is (Length-Ends)/Period,
    Whole is round(N),
    length(Runs, Count),
    Off is (Whole+2)*Count,             % each is rounded by a half at most
    near(Whole*Period+Ends, Length, Off),
    (   Start == ring
    ->  Least = 1
    ;   Least = 0
    ),
    Whole >= Least,
    Stretch is Period/Period0,
    forall(( nth1(I, Runs, Run), nth1(I, Fitted, Fit) ),
           near(Fit, Run*Stretch, 1.0+0.51*Count*Run/Period0)),
    Wanted is (Length-Ends*Period0/Period)/Period0,
    (   Whole =:= Least
    ->  Wanted =< Least+0.5+Count/Period0+1.0e-6
    ;   abs(Whole-Wanted) =< 0.5+Count/Period0+1.0e-6
    )
    ->  true
    ;   format(user_error, 'fit: ~q~n', [fit(Points,Start,End,Runs,Fitted,
                                             Offset)]),
        fail.

way([_], 0) :-
    !.
way([X0-Y0,X1-Y1|Points], Length) :-
    way([X1-Y1|Points], Length0),
    Length is Length0+sqrt((X1-X0)**2+(Y1-Y0)**2).
