:- module(test_lines_written, []).
% covers: lines_dxf, point_table
:- use_module(library(plunit)).
:- use_module(library(sgml)).
:- use_module(library(xpath)).
:- use_module(rules(sanggwan)).
:- use_module(rules(command/lines_out)).
:- use_module(rules(penetration/chain)).
:- use_module(tests('rules/drawing/drawing_reader')).

/* Penetration lines as files, read back: what is read is what chains/1 says. */

% Closed, open, branching, and in a point; of two segments and of three.
parts(bored, [ box(size(4,4,2)),
               at([translate(0,0,-1)], cylinder(radius(1), height(9),
                                                facets(7))) ]).
parts(corner, [ box(size(4,4,2)),
                at([translate(1,1,1)], box(size(2,2.5,9))) ]).
parts(crossed, [ box(size(3,3,3)),
                 at([rotate(axis(1,2,3),40)], box(size(2,2,5))),
                 at([rotate(y,90),translate(-4,0.25,1.5)],
                    cylinder(radius(0.5), height(8), facets(6))) ]).
parts(cut, [ at([translate(0,0,1)], rectangle(size(3,3))),
             at([translate(0.5,0,0)], box(size(1,9,2))) ]).
parts(touched, [ box(size(4,4,2)),
                 at([rotate(x,180),translate(0.25,0.5,4)],
                    cone(radius(1), height(2), facets(8))) ]).

in_parts(Name, Format, Options, Chains, Text) :-
    parts(Name, Parts),
    new_world(World),
    in_world(World,
             ( forall(member(Part, Parts), add_primitive(Part, _)),
               complete_segments,
               penetrate,
               with_output_to(string(Text),
                              ( current_output(Out),
                                write_lines_to(Out, Format, Options) )),
               chains(Chains0),
               maplist(shown, Chains0, Chains) )).

% chain(S1, S2, Kind, Points, Length): Points X-Y-Z, the first of a closed one
% once.
shown(chain(S1, S2, Kind, Lines), chain(S1, S2, Kind, Points, Branch)) :-
    chain_points(Lines, Points0),
    findall(X-Y-Z, member(point(X,Y,Z), Points0), All),
    (   Kind == closed
    ->  append(Points, [_], All)
    ;   Points = All
    ),
    !,
    chain_vertices(Lines, S1, Vs),
    (   Kind == open,
        Vs = [First|_],
        last(Vs, Last),
        member(V, [First,Last]),
        findall(x, ( line(_, S1, _, A, B, S2, _, _, _),
                     member(V, [A,B]) ), [_,_,_|_])
    ->  Branch = branch
    ;   Branch = Kind
    ).

layer(closed, "PENETRATION_CLOSED", 1).
layer(open,   "PENETRATION_OPEN",   5).
layer(branch, "PENETRATION_BRANCH", 30).
layer(point,  "PENETRATION_POINT",  6).

dxf_line(C, line(Layer,Colour,Closed,[C,S1,S2],Places),
         chain(S1, S2, Kind, Points, Branch)) :-
    layer(Branch, Layer, Colour),
    ( Kind == open -> Closed = open ; Closed = Kind ),
    (   Kind == point
    ->  Points = [Point|_],
        Places = [Point-[]]
    ;   findall(P, member(P-[_,_], Places), Points)
    ).

lines_numbers(Text, Word, Numbers) :-
    split_string(Text, "\n", "", Lines),
    findall(Ns, ( member(Line, Lines),
                  split_string(Line, " ", "", [Word|Words]),
                  maplist([W,N]>>number_string(N, W), Words, Ns) ),
            Numbers).

:- begin_tests(lines_written).

test(kinds, Kinds == [branch,closed,open,point]) :-
    findall(Kind, ( parts(Name, _), in_parts(Name, csv, [], Chains, _),
                    member(chain(_,_,_,_,Kind), Chains) ), Kinds0),
    sort(Kinds0, Kinds).
test(dxf, forall(parts(Name, _))) :-
    in_parts(Name, dxf, [], Chains, Text),
    read_lines_dxf(Text, lines(X0-Y0-Z0,X1-Y1-Z1,Entities)),
    same_length(Chains, Entities),
    forall(( nth1(C, Entities, Entity), nth1(C, Chains, Chain) ),
           dxf_line(C, Entity, Chain)),
    findall(X-Y-Z, ( member(chain(_,_,_,Points,_), Chains),
                     member(X-Y-Z, Points) ), All),
    forall(member(Low-High-Axis, [X0-X1-x,Y0-Y1-y,Z0-Z1-z]),
           ( findall(A, ( member(X-Y-Z, All),
                          memberchk(Axis-A, [x-X,y-Y,z-Z]) ), As),
             min_list(As, Low),
             max_list(As, High) )).
test(obj, forall(parts(Name, _))) :-
    in_parts(Name, obj, [], Chains, Text),
    findall([X,Y,Z], ( member(chain(_,_,_,Points,_), Chains),
                       member(X-Y-Z, Points) ), Vs),
    lines_numbers(Text, "v", Vs),
    lines_numbers(Text, "l", Ls),
    lines_numbers(Text, "p", Ps),
    foldl([chain(_,_,Kind,Points,_),V0-All0,V-All]>>
          ( length(Points, N),
            V is V0+N,
            Last is V-1,
            numlist(V0, Last, Is0),
            ( Kind == closed -> append(Is0, [V0], Is) ; Is = Is0 ),
            All0 = [Kind-Is|All] ),
          Chains, 1-Wanted, _-[]),
    findall(Is, ( member(Kind-Is, Wanted), Kind \== point ), Ls),
    findall(Is, member(point-Is, Wanted), Ps).
test(facts, forall(parts(Name, _))) :-
    in_parts(Name, pl, [], Chains, Text),
    tmp_file_stream(File, Out, [encoding(utf8),extension(pl)]),
    write(Out, Text),
    close(Out),
    new_world(World),
    call_cleanup(
        in_world(World,
                 ( load_model(File),
                   findall(C-Points,
                           ( segment(C, curve, penetration(_,_,_)),
                             findall(X-Y-Z, v(C,_,X,Y,Z), Points) ),
                           Found) )),
        delete_file(File)),
    findall(C-Points, nth1(C, Chains, chain(_,_,_,Points,_)), Found).
test(csv, [ nondet,
            forall(( parts(Name, _),
                     member(Format-Separator, [csv-",",tsv-"\t"]) )) ]) :-
    in_parts(Name, Format, [], Chains, Text),
    split_string(Text, "\n", "", [Head|Rows0]),
    append(Rows, [""], Rows0),
    split_string(Head, Separator, "", Columns),
    Columns == [ "chain", "kind", "s1", "s2", "point", "v1", "v2", "x", "y",
                 "z", "length", "p1", "p2", "contact", "place1", "place2" ],
    findall([C,Kind,S1,S2,I,X,Y,Z],
            ( nth1(C, Chains, chain(S1,S2,Kind,Points0,_)),
              (   Kind == closed
              ->  Points0 = [First|_],
                  append(Points0, [First], Points)
              ;   Kind == point
              ->  Points0 = [First|_],
                  Points = [First]
              ;   Points = Points0
              ),
              nth1(I, Points, X-Y-Z) ),
            Wanted),
    findall([C,Kind,S1,S2,I,X,Y,Z]-Length,
            ( member(Row, Rows),
              split_string(Row, Separator, "", Cells),
              same_length(Cells, Columns),
              Cells = [C0,Kind0,S10,S20,I0,_,_,X0,Y0,Z0,L0|_],
              atom_string(Kind, Kind0),
              maplist([T,N]>>number_string(N, T), [C0,S10,S20,I0,X0,Y0,Z0,L0],
                      [C,S1,S2,I,X,Y,Z,Length]) ),
            Found),
    pairs_keys_values(Found, Wanted, Lengths),
    foldl([[_,_,_,_,I,X,Y,Z],L,At0-L0,(X-Y-Z)-L]>>
          (   I =:= 1
          ->  L =:= 0
          ;   At0 = X0-Y0-Z0,
              abs(L-L0-sqrt((X-X0)**2+(Y-Y0)**2+(Z-Z0)**2)) < 1.0e-9
          ),
          Wanted, Lengths, none-0, _).
test(svg, forall(parts(Name, _))) :-
    in_parts(Name, svg, [size(120-80)], Chains, Text),
    setup_call_cleanup(
        open_string(Text, In),
        load_structure(In, DOM, [dialect(xml), max_errors(1)]),
        close(In)),
    findall(Id-S-Other-D,
            ( xpath(DOM, //path, Path),
              Path = element(_, Attributes, _),
              maplist([A,V]>>memberchk(A=V, Attributes),
                      [id,'data-segment','data-other',d], [Id,S,Other,D]) ),
            Paths),
    same_length(Paths, Chains),
    forall(( nth1(C, Paths, Id-S0-Other0-D),
             nth1(C, Chains, chain(S1,S2,Kind,Points,_)) ),
           ( atom_concat('chain-', C, Id),
             maplist(atom_number, [S0,Other0], [S1,S2]),
             ( Kind == closed -> sub_atom(D, _, 1, 0, 'Z') ; true ),
             split_string(D, "MLZ", "", Parts0),
             exclude(==(""), Parts0, Parts),
             (   Kind == point
             ->  true
             ;   same_length(Parts, Points)
             ),
             forall(member(Part, Parts),
                    ( split_string(Part, " ", "", [X0,Y0]),
                      number_string(X, X0),
                      number_string(Y, Y0),
                      X >= 0, X =< 120, Y >= 0, Y =< 80 )) )).

:- end_tests(lines_written).
