:- module(dxf_reader,
          [ read_dxf/2,                 % +Text, -Document
            read_lines_dxf/2            % +Text, -Document
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
/* A reader of DXF, for tests: see drawing_reader.pl. */

%!  read_dxf(+Text, -Document) is det.
%
%   Document is dxf(Header, Types, Layers, Entities): Name-Groups of each
%   variable; type(Name,Runs); layer(Name,Colour,Type);
%   line(Layer,Colour,Runs,Closed,Vertices) with vertices X-Y-Data in
%   thousandths, y up, also of a LINE;
%   text(Layer,Colour,X-Y,Height,Place,Text), or, if it is turned,
%   turned(Angle,text(...)).

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
dxf_entities([0-"LINE",8-Layer|Groups], Tables,
             [line(Layer,Colour,Runs,open,[XA-YA-Data,XB-YB-none])|Entities]) :-
    !,
    dxf_look(Groups, Layer, Tables, Colour, Runs, Groups1),
    must(append([10-XA0,20-YA0,30-"0.000",11-XB0,21-YB0,31-"0.000"], Rest,
                Groups1), line),
    maplist(thousandths, [XA0,YA0,XB0,YB0], [XA,YA,XB,YB]),
    dxf_data(Rest, Data, Rest1),
    dxf_entities(Rest1, Tables, Entities).
dxf_entities([0-"TEXT",8-Layer|Groups], Tables, [Entity|Entities]) :-
    dxf_look(Groups, Layer, Tables, Colour, _, Groups1),
    must(append([10-X0,20-Y0,30-"0.000",40-Height0,1-Text], Rest1, Groups1),
         text),
    Own = text(Layer, Colour, X-Y, Height, Place, Text),
    (   Rest1 = [50-Angle0|Rest0]
    ->  thousandths(Angle0, Angle),
        must(( Angle > 0, Angle < 360000 ), angle),
        Entity = turned(Angle, Own)
    ;   Rest0 = Rest1,
        Entity = Own
    ),
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
    dxf_data(Groups, Data, Groups1),
    dxf_vertices(Groups1, Layer, Vertices, Rest).
dxf_vertices(Rest, _, [], Rest).

dxf_data(Groups0, Data, Groups) :-
    (   Groups0 = [1001-"SANGGWAN",1071-S0,1071-E0|Groups]
    ->  maplist(number_of, [S0,E0], [S,E]),
        Data = S-E
    ;   Data = none,
        Groups = Groups0
    ).
