:- module(sg_model_file,
          [ read_model/1,               % +File
            add_primitive/2             % +Term, -S
          ]).
:- use_module(store,
              [ v/5, e/5, p/3, segment/3, line/9, view/3, projection/1,
                assert_fact/1, retractall_facts/1, facts_transaction/1
              ]).
:- use_module(model_text,
              [ open_model_text/2, close_model_text/1, next_fact/3,
                place_error/2, place_error/3
              ]).
:- use_module(primitive, [is_primitive/1, primitive_shape/4]).
:- autoload(library(aggregate), [aggregate_all/3]).
:- autoload(library(apply), [foldl/4, foldl/5, maplist/2, maplist/3]).
:- autoload(library(lists), [append/3, last/2, member/2, numlist/3]).
:- autoload(library(pairs), [pairs_keys/2]).
/** <module> Model files: the paper's facts read into the world.

A file holds facts of the relations (model_text.pl), in any order, and:

  - `p(S, P, List)`. Where the file gives no e/5 of segment S, List is a vertex
    list, counter-clockwise from outside; edges are made, numbered in the order
    of the file. A negative number is a jump: `[1,2,3,4,1,-5,6,7,8,5]` has no
    edge from 1 to 5. A list without jumps closes itself (PL-2). Where the file
    gives e/5 of S, List is a list of edges.
  - `curve(S, [V1,V2,...])`: edges from each vertex to the next.
  - `segment(S, Kind, Name)`. Without it the kind follows from the rows: `curve`
    without polygons, `solid` if every edge has its opposite, else `surface`;
    the name is the file's. Where the file gives no vertices of S, Name is a
    primitive term that makes them (primitive.pl).
  - `view(Theta, Phi, Rho)` and `projection(Kind)`, once each.

Reading adds to the world: a file's segments come after those that are there,
in its own numbers if there are none. It is all or nothing.

Errors besides those of model_text.pl:

    missing(Relation, S, Id)   twice(Fact)   row(Fact, Error)
    polygon(S, P, Why)         Why: edges(N), open(V), twice(V1,V2), jump,
                               no_edge(V), other_segment
    primitive(What, Term)      kind(Term, Kind, Wanted)
    no_vertices(S, Name)       chain(V)   empty
*/

%!  read_model(+File) is det.
%
%   Add the model in File (`-`: standard input) to the current world.
%
%   @error error(model_error(What), location(File, Line, Column)); the world
%   is then as before.

read_model(File) :-
    setup_call_cleanup(
        open_model_text(File, Text),
        facts_transaction(sg_model_file:text_added(Text)),
        close_model_text(Text)).

text_added(Text) :-
    arg(1, Text, File),
    shifts(Shift),
    streamed(Text, Shift, Later),
    later_added(Later, Shift, File).

%   shifts(Shift): Shift is shift(DS, DL), what is added to the segment and
%   line numbers of the file.

shifts(shift(DS, DL)) :-
    aggregate_all(max(S), segment(S, _, _), DS0),
    aggregate_all(max(L), line(L, _, _, _, _, _, _, _, _), DL0),
    foldl(number_or_zero, [DS0, DL0], [DS, DL], _).

number_or_zero(N0, N, _) :-
    (   number(N0)
    ->  N = N0
    ;   N = 0
    ).
