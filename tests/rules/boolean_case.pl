:- module(sg_test_boolean_case,
          [ in_scene/2,                 % +Terms, :Goal
            result/2,                   % +Expression, -S
            counts/4,                   % +S, -Faces, -Vertices, -Edges
            measured/2,                 % +Segments, -Measures
            files_measured/3,           % +Segments, +Ending, -Measures
            same_file/3,                % +S1, +S2, +Ending
            edge_length/2,              % +S, -Length
            sample/3,                   % +Name, +N, -Seed
            keep_case/3                 % +Name, +Terms, +Expression
          ]).
/** <module> One Boolean of a test: scene, result, and its measures.

The measures are those of the independent checker (checked.pl), of files that
are written here from v/5 and t/6: nothing of the way out is in them.
*/

:- use_module(library(aggregate)).
:- use_module(library(apply)).
:- use_module(library(assoc)).
:- use_module(library(lists)).
:- use_module(library(readutil)).
:- use_module(rules(solid/boolean)).
:- use_module(rules(primitive/primitive_rows)).
:- use_module(rules(model/solid_file)).
:- use_module(rules(store)).
:- use_module(rules(polygon/triangulation)).
:- use_module(tests('rules/checked')).

:- meta_predicate in_scene(+, 0).

%!  in_scene(+Terms, :Goal) is semidet.
%
%   Call Goal in a new world whose segments 1, 2, ... are the primitives Terms.

in_scene(Terms, Goal) :-
    new_world(World),
    in_world(World,
             ( forall(member(Term, Terms), add_primitive(Term, _)),
               complete_segments,
               Goal )).

%!  result(+Expression, -S) is det.
%
%   S is a new segment, the boundary of Expression over segments.

result(Expression, S) :-
    fresh_id(segment, 0, S),
    boolean(Expression, S).

%!  counts(+S, -Faces, -Vertices, -Edges) is det.
%
%   How many polygons S has, vertices that these use, and edges that are seen:
%   places of two ends, whatever the number of polygons there.

counts(S, Faces, Vertices, Edges) :-
    aggregate_all(count, p(S, _, _), Faces),
    findall(A-B,
            ( p(S, _, Es), member(E, Es), e(S, E, V1, V2, 1),
              msort([V1,V2], [A,B]) ),
            Ends0),
    sort(Ends0, Ends),
    length(Ends, Edges),
    findall(V, ( member(A-B, Ends), ( V = A ; V = B ) ), Vs0),
    sort(Vs0, Vs),
    length(Vs, Vertices).

%!  measured(+Segments, -Measures) is det.
%
%   Measures are what the checker says of the triangles of each of Segments.

measured(Segments, Measures) :-
    setup_call_cleanup(
        maplist(temporary, Segments, Files),
        ( maplist(write_segment, Segments, Files),
          checked(Files, Measures)
        ),
        maplist(delete_file, Files)).

temporary(S, File) :-
    temporary(off, S, File).

temporary(Ending, _, File) :-
    tmp_file_stream(File, Stream, [extension(Ending)]),
    close(Stream).

%!  files_measured(+Segments, +Ending, -Measures) is det.
%
%   Measures are what the checker says of the files that write_solid/2 makes of
%   each of Segments: `off`, whose vertices are as they are numbered, or `stl`.

files_measured(Segments, Ending, Measures) :-
    setup_call_cleanup(
        maplist(temporary(Ending), Segments, Files),
        ( maplist(write_solid, Files, Segments),
          (   Ending == off
          ->  checked(['-i'], Files, Measures)
          ;   checked(Files, Measures)
          )
        ),
        maplist(delete_file, Files)).

%!  same_file(+S1, +S2, +Ending) is semidet.
%
%   True when the files of S1 and S2 are equal, byte for byte, except the name.

same_file(S1, S2, Ending) :-
    setup_call_cleanup(
        maplist(temporary(Ending), [S1,S2], Files),
        ( maplist(written_alike, Files, [S1,S2]),
          maplist(bytes_of, Files, [Bytes1,Bytes2])
        ),
        maplist(delete_file, Files)),
    Bytes1 == Bytes2.

written_alike(File, S) :-
    write_solid(File, S, [name(result)]).

bytes_of(File, Bytes) :-
    read_file_to_string(File, Bytes, [encoding(octet)]).

write_segment(S, File) :-
    findall(V-p(X,Y,Z), v(S, V, X, Y, Z), Pairs),
    findall(V-I, nth1(I, Pairs, V-_), Numbered),
    list_to_assoc(Numbered, Numbers),
    findall(P, member(_-P, Pairs), Points),
    findall([A,B,C],
            ( t(S, _, _, A0, B0, C0),
              maplist(number_of(Numbers), [A0,B0,C0], [A,B,C]) ),
            Triangles),
    write_off(File, Points, Triangles).

number_of(Numbers, V, I) :-
    get_assoc(V, Numbers, I).

%!  edge_length(+S, -Length) is det.
%
%   The length of all edges of S, from each of their polygons.

edge_length(S, Length) :-
    aggregate_all(sum(L),
                  ( e(S, _, A, B, 1),
                    v(S, A, X, Y, Z),
                    v(S, B, X1, Y1, Z1),
                    L is sqrt((X-X1)^2+(Y-Y1)^2+(Z-Z1)^2) ),
                  Length).

%!  sample(+Name, +N, -Seed) is nondet.
%
%   Seed is one of N numbers that begin a case; of BOOLEAN_CASES times as many
%   if the environment says so.

sample(Name, N, Seed) :-
    (   getenv('BOOLEAN_CASES', Text)
    ->  atom_number(Text, Times)
    ;   Times = 1
    ),
    Last is max(1, round(N*Times)),
    between(1, Last, I),
    term_hash(Name, Hash),
    Seed is Hash*100000+I.

%!  keep_case(+Name, +Terms, +Expression) is det.
%
%   Write the scene and its operation as a tree for `sanggwan eval` to a file
%   in BOOLEAN_FOUND, if the environment names that folder.

keep_case(Name, Terms, Expression) :-
    (   getenv('BOOLEAN_FOUND', Folder)
    ->  format(atom(File), "~w/~w.pl", [Folder,Name]),
        setup_call_cleanup(
            open(File, write, Out),
            ( forall(nth1(S, Terms, Term), fact(Out, S, Term)),
              length(Terms, N),
              Root is N+1,
              fact(Out, Root, Expression)
            ),
            close(Out))
    ;   true
    ).

fact(Out, S, Term) :-
    format(Out, "~q.~n", [segment(S, solid, Term)]).
