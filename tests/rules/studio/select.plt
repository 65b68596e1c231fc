/* What people point at: of each name what it is, and which others show it. */
% covers: operand_edge
:- module(test_select, []).
:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(rules(model/model), [load_model/1]).
:- use_module(rules(primitive/primitive_rows), [add_primitive/2]).
:- use_module(rules(store)).
:- use_module(rules(studio/select)).
:- use_module(rules(studio/world_state)).

%   with_world(Terms, Goal): call(Goal, World), of primitives or a model's text.

:- meta_predicate with_world(+, 1).

with_world(Terms, Goal) :-
    new_world(World),
    in_world(World, made(Terms)),
    world_begun(World),
    setup_call_cleanup(selection_forgotten,
                       call(Goal, World),
                       ( selection_forgotten, world_forgotten(World) )).

made(Terms) :-
    (   is_list(Terms)
    ->  forall(member(Term, Terms), add_primitive(Term, _))
    ;   setup_call_cleanup(
            ( tmp_file_stream(File, Out, [extension(pl), encoding(utf8)]),
              write(Out, Terms),
              close(Out) ),
            load_model(File),
            delete_file(File))
    ).

two([box(size(2,2,2)), at([translate(1,1,1)], box(size(2,2,2)))]).

told(Names, Dicts, World) :-
    selected(World, _{names:Names}, Reply),
    Dicts = Reply.selected.

one(Name, Dict) :-
    two(Terms),
    with_world(Terms, told([Name], [Dict])).

refused(Head, What, World) :-
    catch(( selected(World, Head, _), What = none ),
          error(request_error(What), _), true).

%   all_shown(World): what a name shows, shows it.

all_shown(World) :-
    in_state(World, shown,
             findall(Name,
                     ( e(S, E, _, _, _), format(string(Name), "s~de~d", [S,E])
                     ; p(S, P, _), format(string(Name), "s~dp~d", [S,P])
                     ; v(S, V, _, _, _),
                       format(string(Name), "s~dv~d", [S,V])
                     ; line(L, _, _, _, _, _, _, _, _),
                       format(string(Name), "l~d", [L]) ),
                     Names0)),
    sort(Names0, Names),
    length(Names, N),
    assertion(( N > 100, N < 1000 )),
    told(Names, Dicts, World),
    findall(A-B,
            ( member(Dict, Dicts),
              get_dict(name, Dict, A),
              get_dict(shows, Dict, Shows),
              member(B, Shows) ),
            Pairs0),
    sort(Pairs0, Pairs),
    % a polygon shows the other halves of its edges too
    findall(A-B,
            ( member(A-B, Pairs),
              \+ memberchk(B-A, Pairs),
              \+ ( kinds(A, B, p-e), member(B-C, Pairs),
                   memberchk(C-A, Pairs) ) ),
            Alone),
    assertion(Alone == []),
    findall(Kind, ( member(A-B, Pairs), kinds(A, B, Kind) ), Kinds0),
    sort(Kinds0, Kinds),
    assertion(Kinds == [e-e,e-l,e-p,e-v,l-e,p-e,v-e]),
    % an edge has two ends, one other half and one or more polygons
    forall(( member(Dict, Dicts), get_dict(kind, Dict, edge) ),
           ( get_dict(shows, Dict, Shows),
             findall(v, ( member(Name, Shows), letter(Name, v) ), Vs),
             assertion(Vs == [v,v]) )).

kinds(A, B, KindA-KindB) :-
    letter(A, KindA),
    letter(B, KindB).

letter(Name, Letter) :-
    (   sub_string(Name, 0, _, _, "l")
    ->  Letter = l
    ;   member(Letter, [e,p,v]),
        atom_string(Letter, Text),
        sub_string(Name, _, _, _, Text)
    ->  true
    ).

again(Replies, World) :-
    selected(World, _{names:["s1e1","s2"]}, _),
    selected(World, _{}, First),
    selected(World, _{names:["s1"], keep:false}, Other),
    selected(World, _{}, Second),
    findall(Names-Gone,
            ( member(Reply, [First,Other,Second]),
              findall(Name, ( member(D, Reply.selected), Name = D.name ),
                      Names),
              Gone = Reply.gone ),
            Replies).

gone(Gone, World) :-
    selected(World, _{names:["s1","s2p3","l1"]}, _),
    new_world(World2),
    in_world(World2, add_primitive(box(size(1,1,1)), _)),
    world_begun(World2),
    selected(World2, _{}, Reply),
    Gone = Reply.gone,
    world_forgotten(World2).

ends(Names, Ends, World) :-
    selected(World, _{names:Names}, Reply),
    dict_pairs(Reply.ends, _, Ends0),
    findall(Name, member(Name-_, Ends0), Ends),
    in_state(World, shown,
             forall(member(Name-[[X1,Y1,Z1],[X2,Y2,Z2]], Ends0),
                    ( sub_atom(Name, B, 1, _, e),
                      From is B+1,
                      sub_atom(Name, 1, _, _, Rest0),
                      atomic_list_concat([STerm|_], e, Rest0),
                      atom_number(STerm, S),
                      sub_atom(Name, From, _, 0, ETerm),
                      atom_number(ETerm, E),
                      e(S, E, V1, V2, _),
                      v(S, V1, X1, Y1, Z1),
                      v(S, V2, X2, Y2, Z2) ))).

%   A hole through a block.

drilled("segment(1, solid, box(size(4,4,1))).\n\c
         segment(2, solid, box(size(1,1,3))).\n\c
         segment(3, solid, difference([1,2])).\n").

%   operand_shows(Name, Rs, Faces, World): how far from the axis the ends are of
%   the edges that an operand shows, and how many faces.

operand_shows(Name, Rs, Faces, World) :-
    selected(World, _{names:[Name]}, Reply),
    [Dict] = Reply.selected,
    assertion(_{kind:segment, explain:[]} :< Dict),
    get_dict(shows, Dict, Shows),
    selected(World, _{names:Shows, keep:false}, Shown),
    dict_pairs(Shown.ends, _, Ends),
    findall(R, ( member(Key-Points, Ends), atom_string(Key, Edge),
                 memberchk(Edge, Shows), member([X,Y,_], Points),
                 R is max(abs(X), abs(Y)) ),
            Rs0),
    sort(Rs0, Rs),
    aggregate_all(count, ( member(Show, Shows),
                           sub_string(Show, _, _, _, "p") ), Faces).

pieces(Explained, World) :-
    selected(World, _{names:["s3","s3p1"]}, Reply),
    findall(Explain, ( member(Dict, Reply.selected),
                       get_dict(explain, Dict, Explain) ), Explained).

:- begin_tests(select).

test(all_shown, true) :-
    two(Terms),
    with_world(Terms, all_shown).
test(of_each, [ forall(member(Name-Kind-Goal-Explain,
      [ "s1"-segment-"segment(1, Kind, Name)"-[],
        "s1e1"-edge-"e(1, 1, V1, V2, Et)"-["hidden(1,1)"],
        "s2p3"-polygon-"p(2, 3, Es)"-[],
        "s1v5"-vertex-"v(1, 5, X, Y, Z)"-["vertex(1,5)"],
        "l1"-line-"line(1, S1, P1, A1, B1, S2, P2, A2, B2)"-["line(1)"],
        "s1e-4"-edge-"drawn(D, 1, -4, From, To, Visibility, Role)"-[] ])),
                true([Told,Asked,Why] == [Kind,Goal,Explain]) ]) :-
    one(Name, Dict),
    _{name:Name, kind:Told, goal:Asked, explain:Why} :< Dict.
test(edge_of_a_line, true) :-
    two(Terms),
    with_world(Terms, told(["l1"], [Line])),
    get_dict(shows, Line, [Edge|_]),
    one(Edge, Dict),
    get_dict(explain, Dict, ["line(1)",Hidden]),
    sub_string(Hidden, 0, _, _, "hidden(").
test(no_name, [ forall(member(Name,
        [ "s3", "s1e999", "s1p99", "s1v99", "l99", "s3e-1", "s1j1" ])),
                What == no_name(Name) ]) :-
    two(Terms),
    with_world(Terms, refused(_{names:[Name]}, What)).
test(bad_names, [ forall(member(Names,
        [ ["x"], [""], ["s"], ["s0"], ["s01"], ["s1x2"], ["s1e"], ["s1e0"],
          ["s1e1 "], ["s1p-1"], ["s1v-1"], ["l"], ["l-1"], ["s1e1e1"],
          ["s1000000000"], [1], [s1], "s1", ["s1","s"] ])),
                  What == bad_key(names, names) ]) :-
    two(Terms),
    with_world(Terms, refused(_{names:Names}, What)).
test(longest_number, What == no_name("s999999999")) :-
    two(Terms),
    with_world(Terms, refused(_{names:["s999999999"]}, What)).
test(how_many, Whats == [none,bad_key(names, names)]) :-
    two(Terms),
    findall(What,
            ( member(N, [1000,1001]),
              length(Names, N),
              maplist(=("s1"), Names),
              with_world(Terms, refused(_{names:Names}, What)) ),
            Whats).
test(again, Replies == [["s1e1","s2"]-[],["s1"]-[],["s1e1","s2"]-[]]) :-
    two(Terms),
    with_world(Terms, again(Replies)).
test(gone, Gone == ["s2p3","l1"]) :-
    two(Terms),
    with_world(Terms, gone(Gone)).
test(ends_of_edges, Ends == [s1e1,s1e3]) :-
    with_world([rectangle(size(2,2))], ends(["s1e1","s1e3"], Ends)).
test(ends_of_a_segment, Ends == []) :-
    with_world([rectangle(size(2,2))], ends(["s1"], Ends)).
test(ends_of_a_polygon, Ends == [s1e1,s1e2,s1e3,s1e4]) :-
    with_world([rectangle(size(2,2))], ends(["s1p1"], Ends)).
%   The block has its outer edges and those of the hole's mouths; the hole the
%   latter alone.
test(operands, Found == [1-[0.5,2.0]-6,2-[0.5]-4]) :-
    drilled(Text),
    findall(S-Rs-Faces,
            ( member(S-Name, [1-"s1",2-"s2"]),
              with_world(Text, operand_shows(Name, Rs, Faces)) ),
            Found).
test(faces_are_pieces, Explained == [[],["piece(3,1)"]]) :-
    drilled(Text),
    with_world(Text, pieces(Explained)).

:- end_tests(select).
