/* CityJSON: what is read of each geometry, and what has a fault is refused with
   its path, and nothing of it stays. */
:- module(test_cityjson, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(http/json)).
:- use_module(library(plunit)).
:- use_module(rules(gluing/regions)).
:- use_module(rules(limits)).
:- use_module(rules(model/model)).
:- use_module(rules(solid/csg_evaluate)).
:- use_module(rules(solid/glue)).
:- use_module(rules(store)).
:- use_module(rules(vocabulary)).
:- use_module(tests(rules/polyhedron), [in_new_world/1]).

:- dynamic heard/1.
:- multifile user:message_hook/3.

user:message_hook(sanggwan(What), warning, _) :-
    functor(What, Name, _),
    memberchk(Name, [cityjson_open,cityjson_left_out,cityjson_no_area]),
    arg(2, What, N),
    assertz(test_cityjson:heard(Name-N)).

:- meta_predicate with_text(+, 1).

%   with_text(Text, Goal): Goal of a file with Text, in a world of its own.

with_text(Text, Goal) :-
    retractall(heard(_)),
    tmp_file_stream(File, Out, [extension(json),encoding(utf8)]),
    call_cleanup(write(Out, Text), close(Out)),
    call_cleanup(in_new_world(call(Goal, File)), delete_file(File)).

%   city(Geometries, Text): of an object `one`, with the corners of two cubes.

city(Geometries, Text) :-
    format(string(Text),
           "{\"type\":\"CityJSON\",\"version\":\"2.0\",\c
             \"transform\":{\"scale\":[0.001,0.001,0.1],\c
                            \"translate\":[10.7,0,-1]},\c
             \"CityObjects\":{\"one\":{\"type\":\"Building\",\c
                              \"geometry\":[~w]}},\c
             \"vertices\":[[0,0,0],[1000,0,0],[1000,1000,0],[0,1000,0],\c
                           [0,0,10],[1000,0,10],[1000,1000,10],[0,1000,10],\c
                           [0,0,20],[1000,0,20],[1000,1000,20],\c
                           [0,1000,20]]}", [Geometries]).

low("[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]").
high("[[4,7,6,5]],[[8,9,10,11]],[[4,5,9,8]],[[5,6,10,9]],[[6,7,11,10]],\c
      [[7,4,8,11]]").

geometry(Type, Lod, Boundaries, Text) :-
    format(string(Text),
           "{\"type\":\"~w\",\"lod\":\"~w\",\"boundaries\":~w}",
           [Type,Lod,Boundaries]).

one(Type, Boundaries, Text) :-
    geometry(Type, "2", Boundaries, Geometry),
    city(Geometry, Text).

loaded(File) :-
    load_model(File).

kinds(Text, Kinds) :-
    with_text(Text, kinds_of(Kinds)).

kinds_of(Kinds, File) :-
    load_model(File),
    findall(S-Kind, segment(S, Kind, _), Pairs0),
    sort(Pairs0, Pairs),
    findall(Kind, member(_-Kind, Pairs), Kinds).

:- dynamic user:message_hook/3.
:- multifile user:message_hook/3.

:- begin_tests(cityjson).

test(solid, Kinds == [solid]) :-
    low(Low),
    format(string(Boundaries), "[[~w]]", [Low]),
    one('Solid', Boundaries, Text),
    kinds(Text, Kinds).
test(open, Kinds-Heard == [surface]-[cityjson_open-1]) :-
    one('Solid', "[[[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]]]]", Text),
    kinds(Text, Kinds),
    findall(What, heard(What), Heard).
test(several, [ forall(member(Type-Wanted,
                              [ 'MultiSolid'-[solid,solid],
                                'CompositeSolid'-[solid,solid,cells] ])),
                Kinds == Wanted ]) :-
    two(Type, Text),
    kinds(Text, Kinds).
test(flat, [ forall(member(Type-Boundaries-Wanted,
                           [ 'MultiSurface'-"[[[0,1,2,3]],[[4,5,6]]]"-surface,
                             'CompositeSurface'-"[[[0,1,2,3]]]"-surface,
                             'MultiLineString'-"[[0,1,2],[4,5]]"-curve,
                             'MultiPoint'-"[0,1,2]"-curve ])),
             Kinds == [Wanted] ]) :-
    one(Type, Boundaries, Text),
    kinds(Text, Kinds).

%   A ring that goes there and back has no area; a vertex that is there twice is
%   there once.

test(no_area, [ forall(no_area(Type, Boundaries, Wanted, Left)),
                Kinds-Edges-Heard == Wanted-[cityjson_no_area-Left] ]) :-
    one(Type, Boundaries, Text),
    with_text(Text, kinds_edges(Kinds, Edges)),
    findall(What, heard(What), Heard).

no_area('MultiSurface', "[[[0,0,1,1]],[[0,1,1,2,3]],[[4,5,6,7],[4,4,6,6]]]",
        [surface]-[4,4], 1).
no_area('MultiSurface', "[[[0,1,2]],[[0,1,0]],[[2,2,2]]]", [surface]-[3], 2).
no_area('Solid', Boundaries, [solid]-[4,4,4,4,4,4], 1) :-
    low(Low),
    format(string(Boundaries), "[[~w,[[0,0,1,1]]]]", [Low]).

kinds_edges(Kinds, Edges, File) :-
    kinds_of(Kinds, File),
    findall(N, ( p(_, _, Es), length(Es, N) ), Edges).

two(Type, Text) :-
    low(Low),
    high(High),
    format(string(Boundaries), "[[[~w]],[[~w]]]", [Low,High]),
    one(Type, Boundaries, Text).

%   Two cubes with one face: glued without a cut.

test(composite, Counts == [12,20,11,3]) :-
    two('CompositeSolid', Text),
    with_text(Text, composite_counts(Counts)).

composite_counts([V,E,F,R], File) :-
    load_model(File),
    glue_report(3, Report),
    _{vertices:V, edges:E, faces:F, regions:R} :< Report.counts.

%   Rationals, rounded once: 10.7 + 1000/1000 and not what doubles add up to.

test(transform, Xs-Zs == [10.7,11.7]-[-1.0,0.0]) :-
    low(Low),
    format(string(Boundaries), "[[~w]]", [Low]),
    one('Solid', Boundaries, Text),
    with_text(Text, places(Xs, Zs)).

places(Xs, Zs, File) :-
    load_model(File),
    findall(X, v(1, _, X, _, _), Xs0),
    findall(Z, v(1, _, _, _, Z), Zs0),
    sort(Xs0, Xs),
    sort(Zs0, Zs).

%   The highest level of detail, or the one that is asked for.

test(lod, [ forall(member(Options-Wanted, [[]-4,[lod('1')]-3])),
            N == Wanted ]) :-
    geometry('MultiSurface', "1", "[[[0,1,2]]]", One),
    geometry('MultiSurface', "2.2", "[[[0,1,2,3]]]", Two),
    format(string(Both), "~w,~w", [One,Two]),
    city(Both, Text),
    with_text(Text, vertices(Options, N)).

vertices(Options, N, File) :-
    load_model(File, Options),
    aggregate_all(count, v(_, _, _, _, _), N).

test(hole, Loops == 2) :-
    one('MultiSurface', "[[[0,1,2,3],[4,7,6,5]]]", Text),
    with_text(Text, loops(Loops)).

loops(N, File) :-
    load_model(File, [triangles(false)]),
    facet_loops(1-1, Loops),
    length(Loops, N).

%   A ring that ends where it began loses its end.

test(ended, N == 4) :-
    one('MultiSurface', "[[[0,1,2,3,0]]]", Text),
    with_text(Text, vertices([], N)).
test(template, Heard == [cityjson_left_out-1]) :-
    city("{\"type\":\"GeometryInstance\",\"template\":0,\"boundaries\":[0]}",
         Text),
    with_text(Text, loaded),
    findall(What, heard(What), Heard).

/* - - - faults - - - */

faulty("{", '/', syntax).
faulty("[]", '/type', no_cityjson).
faulty("{\"type\":\"CityJSON\"}", '/', missing(version)).
faulty("{\"type\":\"CityJSON\",\"version\":\"3.0\"}", '/version',
       version("3.0")).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\"}", '/',
       missing('CityObjects')).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\c
        \"vertices\":[[0,0]]}", '/vertices/0', triple).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\c
        \"vertices\":[[0,0,\"NaN\"]]}", '/vertices/0', triple).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\c
        \"vertices\":[],\"transform\":{\"scale\":[1,1]}}", '/transform',
       missing(translate)).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\c
        \"vertices\":[[0,0,0],[0,1e300,0]]}", '/vertices/1', too_far).
faulty("{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\c
        \"vertices\":[],\"transform\":null}", '/transform', nesting).
faulty(Text, '/CityObjects/one/geometry/0/boundaries/0/0/1',
       index(12, 12)) :-
    one('MultiSurface', "[[[0,12,2]]]", Text).
faulty(Text, '/CityObjects/one/geometry/0/boundaries/0/0/1',
       index(-1, 12)) :-
    one('MultiSurface', "[[[0,-1,2]]]", Text).
faulty(Text, '/CityObjects/one/geometry/0/boundaries/0/0/2', index(2.5)) :-
    one('MultiSurface', "[[[0,1,2.5]]]", Text).
faulty(Text, '/CityObjects/one/geometry/0/boundaries/0/0', nesting) :-
    one('MultiSurface', "[[0,1,2]]", Text).
faulty(Text, '/CityObjects/one/geometry/0/boundaries/0/0', ring) :-
    one('MultiSurface', "[[[0,1]]]", Text).
faulty(Text, '/CityObjects/one/geometry/0', geometry("Cone")) :-
    one('Cone', "[[[0,1,2]]]", Text).
faulty(Text, '/CityObjects/one/geometry/0', missing(boundaries)) :-
    city("{\"type\":\"Solid\"}", Text).

test(fault, [ forall(faulty(Text, Path, Why)),
              error(model_error(cityjson(Path, Why))) ]) :-
    with_text(Text, loaded).

%   Of a file with a fault in its last object nothing is there.

test(nothing_loaded, N == 0) :-
    geometry('MultiSurface', "2", "[[[0,1,2]]]", Good),
    geometry('MultiSurface', "2", "[[[0,1,99]]]", Bad),
    format(string(Both), "~w,~w", [Good,Bad]),
    city(Both, Text),
    with_text(Text, left_after(N)).

left_after(N, File) :-
    catch(load_model(File), error(model_error(_), _), true),
    aggregate_all(count, v(_, _, _, _, _), N).

%   Whatever stands in the place of any value: the file is read, or refused with
%   a path, and then nothing of it is there.

test(values, [ setup(asserta(( user:message_hook(_, _, _) :- true ), Ref)),
               cleanup(erase(Ref)),
               Wrong == [] ]) :-
    low(Low),
    format(string(Shells), "[[~w]]", [Low]),
    geometry('Solid', "2", Shells, Geometry),
    city(Geometry, Text),
    atom_json_dict(Text, City, []),
    findall(Path-Value-Why,
            ( place(City, Path, _),
              other_value(Value),
              in_place(Path, Value, City, Other),
              with_output_to(string(Text1), json_write_dict(current_output,
                                                            Other)),
              with_text(Text1, read_or_refused(Why)),
              Why \== fine ),
            Wrong).

place(_, [], _).
place(Dict, [Key|Path], Value) :-
    is_dict(Dict),
    get_dict(Key, Dict, Below),
    place(Below, Path, Value).
place(List, [I|Path], Value) :-
    is_list(List),
    nth0(I, List, Below),
    I < 2,
    place(Below, Path, Value).

in_place([], Value, _, Value).
in_place([Key|Path], Value, Dict0, Dict) :-
    is_dict(Dict0),
    !,
    in_place(Path, Value, Dict0.Key, Below),
    Dict = Dict0.put(Key, Below).
in_place([I|Path], Value, List0, List) :-
    nth0(I, List0, Below0, Others),
    in_place(Path, Value, Below0, Below),
    nth0(I, List, Below, Others).

other_value(Value) :-
    member(Value, [null,-1,1.5,1.0e300,"word",[],[[]],_{},true]).

read_or_refused(Why, File) :-
    catch(( load_model(File), Error = none ), Error, true),
    (   Error == none
    ->  Why = fine
    ;   Error = error(model_error(_), _),
        \+ v(_, _, _, _, _),
        \+ segment(_, _, _)
    ->  Why = fine
    ;   Why = Error
    ).

test(no_lod, error(model_error(cityjson('/CityObjects', no_lod('9'))))) :-
    one('MultiSurface', "[[[0,1,2]]]", Text),
    with_text(Text, vertices([lod('9')], _)).
test(missing, error(model_error(cannot_read(missing)))) :-
    in_new_world(load_model('no_such_file.json')).

%   Files of others, where they are: buildings of The Hague, glued.

shared(Name, Path) :-
    atom_concat('../shared/data/cityjson/', Name, Path),
    exists_file(Path).

test(buildings, [ condition(shared('DH_01_subs.city.json', _)),
                  Kinds == [solid-9] ]) :-
    shared('DH_01_subs.city.json', Path),
    in_new_world(( load_model(Path, [triangles(false)]),
                   aggregate_all(count, segment(_, solid, _), N),
                   aggregate_all(count, segment(_, _, _), N) )),
    Kinds = [solid-N].
%   Walls of two parts of one building run into each other by 1.021 mm, on an
%   area of 8.686: more than the file's millimetre explains. So they overlap,
%   and are one wall where that is asked for.

test(buildings_glued, [ condition(shared('DH_01_subs.city.json', _)),
                        setup(asserta(( user:message_hook(_, warning, _) :-
                                            true ), Ref)),
                        cleanup(erase(Ref)),
                        forall(member(Options-Wanted,
                                      [[]-11,[tolerance(0.002)]-10])),
                        Counts == Wanted ]) :-
    shared('DH_01_subs.city.json', Path),
    in_new_world(buildings_glued(Options, Path, Counts0, Overlaps)),
    (   Options == []
    ->  Overlaps = [Volume],
        abs(Volume-8.686*0.001021/2) < 1.0e-6,
        Counts0 = _-Counts
    ;   Overlaps == [],
        Counts0 = [92,148,69]-Counts
    ).

buildings_glued(Options, Path, [V,E,F]-R, Overlaps) :-
    load_model(Path, [triangles(false)]),
    findall(S, segment(S, solid, _), Ss0),
    sort(Ss0, Ss),
    assert_fact(segment(1000, cells, glue(Ss))),
    evaluate(1000, Options),
    glue_report(1000, Report),
    _{vertices:V, edges:E, faces:F, regions:R} :< Report.counts,
    findall(Volume,
            ( member(Region, Report.regions),
              Region.inside = [_,_|_],
              Volume = Region.volume ),
            Overlaps).

test(composite_file, [ condition(shared('composite_solid_with_material.json',
                                        _)),
                       Counts == [12,20,11,3] ]) :-
    shared('composite_solid_with_material.json', Path),
    in_new_world(composite_counts(Counts, Path)).

%   Delft: no building has a floor. With floors 136 pairs of them have walls in
%   common, 173 wall edges (counted in the file), and each is a cell.

test(delft, [ condition(shared('delft.json', _)),
              setup(asserta(( user:message_hook(_, _, _) :- true ), Ref)),
              cleanup(erase(Ref)),
              Open-Counts == (0-570)-counts(160,160,136,173) ]) :-
    shared('delft.json', Path),
    in_new_world(( load_model(Path, [triangles(false)]), solids(Open) )),
    in_new_world(delft_glued(Path, Counts)).

solids(Solids-Surfaces) :-
    aggregate_all(count, segment(_, solid, _), Solids),
    aggregate_all(count, segment(_, surface, _), Surfaces).

delft_glued(Path, counts(N,Cells,Pairs,Walls)) :-
    load_model(Path, [triangles(false),close(true)]),
    findall(S, segment(S, solid, _), Ss0),
    sort(Ss0, Ss),
    length(Ss, N),
    assert_fact(segment(1000, cells, glue(Ss))),
    evaluate(1000),
    aggregate_all(count, region(1000, _, cell), Cells),
    findall(P-(S1-S2),
            ( from_p(1000, P, S1, _, _), from_p(1000, P, S2, _, _), S1 < S2 ),
            All0),
    sort(All0, All),
    length(All, Walls),
    sort(2, @<, All, Different),
    length(Different, Pairs).

test(too_large, [ setup(( limit_value(file, Most), set_limit(file, 100) )),
                  cleanup(set_limit(file, Most)),
                  error(model_error(limit(file, 100))) ]) :-
    one('MultiSurface', "[[[0,1,2]]]", Text),
    with_text(Text, loaded).

:- end_tests(cityjson).
