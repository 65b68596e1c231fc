:- module(sg_store,
          [ v/5,                      % ?S, ?V, ?X, ?Y, ?Z
            e/5,                      % ?S, ?E, ?V1, ?V2, ?Et
            p/3,                      % ?S, ?P, ?Es
            plane/6,                  % ?S, ?P, ?Nx, ?Ny, ?Nz, ?D
            t/6,                      % ?S, ?P, ?T, ?V1, ?V2, ?V3
            leaf_v/5,                 % ?S, ?V, ?X, ?Y, ?Z
            leaf_e/5,                 % ?S, ?E, ?V1, ?V2, ?Et
            leaf_p/3,                 % ?S, ?P, ?Es
            leaf_t/6,                 % ?S, ?P, ?T, ?V1, ?V2, ?V3
            segment/3,                % ?S, ?Kind, ?Name
            origin/3,                 % ?S, ?Item, ?Origin
            from_v/4,                 % ?S, ?V, ?S0, ?V0
            from_p/5,                 % ?S, ?P, ?S0, ?P0, ?Sense
            line/9,                   % ?L, ?S1, ?P1, ?A1, ?B1,
                                      % ?S2, ?P2, ?A2, ?B2
            region/3,                 % ?S, ?R, ?Role
            sides/4,                  % ?S, ?P, ?Below, ?Above
            from_r/4,                 % ?S, ?R, ?S0, ?R0
            lies_in/3,                % ?S, ?Item, ?In
            gluing/2,                 % ?S, ?Wish
            unfolding/2,              % ?S, ?Wish
            piece/3,                  % ?S, ?P, ?K
            joint/6,                  % ?S, ?J, ?E1, ?E2, ?Kind, ?Angle
            view/3,                   % ?Theta, ?Phi, ?Rho
            projection/1,             % ?Kind
            title_block/2,            % ?Item, ?Text
            span/7,                   % ?Y, ?K, ?X1, ?X2, ?R, ?S, ?F
            look/2,                   % ?S, ?Property
            light/2,                  % ?N, ?Property
            param/2,                  % ?Name, ?Value
            param_about/2,            % ?Name, ?Items
            formula/2,                % ?Row, ?Fact
            question/2,               % ?Name, ?Goal
            screen/5,                 % ?S, ?V, ?Xs, ?Ys, ?Zs
            contour/13,               % ?S, ?K, ?T, ?I1, ?F1, ?I2, ?F2,
                                      % ?To, ?Ts, ?X1, ?Y1, ?X2, ?Y2
            surface_facing/6,         % ?S, ?T, ?I, ?From, ?To, ?Ts
            drawn/7,                  % ?D, ?S, ?E, ?From, ?To,
                                      % ?Visibility, ?Role
            assert_fact/1,            % +Fact
            assert_fact/2,            % +Fact, -Row
            assert_after/1,           % +Fact
            retract_fact/1,           % ?Fact
            retract_fact/2,           % ?Fact, +Options
            retractall_facts/1,       % ?Fact
            edge_polygon/3,           % ?S, ?E, ?P
            vertex_triangle/3,        % ?S, ?V, ?T
            fact_row/2,               % ?Fact, ?Row
            facts_transaction/1,      % :Goal
            facts_transaction/2,      % :Goal, +Options
            facts_snapshot/1,         % :Goal
            facts_undo/0,
            facts_redo/0,
            facts_undo_limit/1,       % +Steps
            new_world/1,              % -World
            in_world/2,               % +World, :Goal
            in_passing_world/1,       % :Goal
            current_world/1,          % -World
            set_world/1,              % +World
            fresh_id/3,               % +Relation, +S, -Id
            segment_stamp/2,          % +S, -Stamp
            segment_stamps/2,         % +Ss, -Stamps
            segments_key/2,           % +Ss, -Key
            relation/3,               % ?Name, ?Arity, ?Doc
            relation_column/5,        % ?Relation, ?Position, ?Column, ?Type,
                                      % ?Refers
            column_doc/3,             % ?Relation, ?Position, ?Doc
            column_domain/3,          % ?Relation, ?Position, -Values
            facts_statistics/2        % ?Relation, -Statistics
          ]).

:- if(\+ predicate_property(sg_store:v(_,_,_,_,_), foreign)).
:- use_foreign_library(foreign(sanggwan)).
:- endif.

/** <module> The fact engine: relations, worlds, transactions.

The doors to engine/: every foreign predicate of the store is exported and
documented here.

The relations v/5, e/5, p/3 ... are ordinary predicates over C columns: they
answer in every instantiation mode, in the order of their rows (the order of
asserting, until the slots of retracted rows are used again), and leave no
choice point on the last answer. A call sees the facts as they were when it
was called, whatever changes before it is done (logical update view). As
with facts of Prolog itself, an argument of another type simply does not
match: v(1, 1, X, Y, Z) with X = 1 fails, since coordinates are floats.

A world holds facts. Each thread has a current world, which all predicates
here use; the thread that loads the library gets one, other threads begin
without and get `existence_error(sg_world, current)`. A world that nothing
refers to any more is freed with its handle by atom garbage collection.

@see [PL] section 2 for the five relations; docs/internals/store.md
*/

:- use_module(library(apply), [maplist/3]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/3]).

:- meta_predicate
    facts_transaction(0),
    facts_transaction(0, +),
    facts_snapshot(0),
    in_world(+, 0),
    in_passing_world(0).

/* ---- relations ----------------------------------------------------------

   All foreign; arguments and meaning as engine/relations.def says.
*/

%!  v(?S, ?V, ?X, ?Y, ?Z) is nondet.
%
%   True when vertex V of segment S is at X, Y, Z.

%!  e(?S, ?E, ?V1, ?V2, ?Et) is nondet.
%
%   True when E is a directed edge of segment S from V1 to V2; Et is 1 for a
%   real edge, 0 for an auxiliary one. Indexed by E, V1, V2 and V1 with V2,
%   each with S.

%!  p(?S, ?P, ?Es:list(integer)) is nondet.
%
%   True when P is a polygon of segment S with the set of edges Es, in the
%   order they were given.

%!  plane(?S, ?P, ?Nx, ?Ny, ?Nz, ?D) is nondet.
%
%   True when polygon P of segment S lies in Nx*X + Ny*Y + Nz*Z + D = 0, its
%   unit normal pointing outward.

%!  t(?S, ?P, ?T, ?V1, ?V2, ?V3) is nondet.
%
%   True when T is a triangle of polygon P, its corners counter-clockwise
%   seen from outside.

%!  leaf_v(?S, ?V, ?X, ?Y, ?Z) is nondet.
%
%   True when vertex V of segment S was at X, Y, Z before it was moved, within
%   the tolerance, to touch another segment (resolve.pl).

%!  leaf_e(?S, ?E, ?V1, ?V2, ?Et) is nondet.
%
%   True when E was an edge of segment S before its polygon, or the curve that
%   it is of, was cut. Edges that were not divided are in e/5 too.

%!  leaf_p(?S, ?P, ?Es:list(integer)) is nondet.
%
%   True when P is a polygon of segment S that was cut; before any cut its
%   edges were Es, of leaf_e/5.

%!  leaf_t(?S, ?P, ?T, ?V1, ?V2, ?V3) is nondet.
%
%   True when T was a triangle of polygon P before it was cut: a *leaf*. Cuts
%   are taken between leaves only, so they name original vertices only. The
%   triangles of a polygon that was not cut are its leaves.

%!  segment(?S, ?Kind, ?Name) is nondet.
%
%   True when segment S is a solid, surface, curve, cells or pattern (a flat
%   development, in a plane of its own); Name is any ground term.

%!  origin(?S, ?Item, ?Origin) is nondet.
%
%   True when Item, one of v(V), e(E) and p(P), of segment S was made as
%   Origin says. Indexed by S with Item, and by Origin.

%!  from_v(?S, ?V, ?S0, ?V0) is nondet.
%
%   True when vertex V of segment S, the result of an operation on solids, was
%   vertex V0 of segment S0. A vertex that a cut made has an origin/3 instead.

%!  from_p(?S, ?P, ?S0, ?P0, ?Sense) is nondet.
%
%   True when polygon P of segment S, a result, has a part of polygon P0 of
%   segment S0, or all of it. Sense is 1 if it looks the same way, -1 if it was
%   turned over. Coplanar parts of several polygons can be one polygon.

%!  line(?L, ?S1, ?P1, ?A1, ?B1, ?S2, ?P2, ?A2, ?B2) is nondet.
%
%   True when L is a piece of a penetration line from A1 to B1 in polygon P1
%   of segment S1, the same as A2 to B2 in polygon P2 of segment S2. A contact
%   in a point alone is a piece with A1 = B1 and A2 = B2.

%!  region(?S, ?R, ?Role) is nondet.
%
%   True when R is a region of space between faces of segment S: the `outside`,
%   which is one, a `cell`, a `void` (bounded, but in no solid) or a `slit`
%   (without volume, between faces that lie on each other).

%!  sides(?S, ?P, ?Below, ?Above) is nondet.
%
%   True when the regions behind polygon P and where its normal points are Below
%   and Above.

%!  from_r(?S, ?R, ?S0, ?R0) is nondet.
%
%   True when region R of segment S, a glue, is inside region R0 of its operand
%   S0: of a solid the inside is 1. A region inside of several operands is where
%   they overlap.

%!  lies_in(?S, ?Item, ?In) is nondet.
%
%   True when Item, a wire e(E) or a lone vertex v(V), lies in the region r(R)
%   that In is; or v(V), a vertex of other faces, inside the polygon p(P).

%!  gluing(?S, ?Wish) is nondet.
%
%   True when Wish is wanted of the glue S: glue_choice.pl.

%!  unfolding(?S, ?Wish) is nondet.
%
%   True when Wish is wanted of the development of segment S (DV-7).

%!  piece(?S, ?P, ?K) is nondet.
%
%   True when polygon P of the pattern S lies in its piece K.

%!  joint(?S, ?J, ?E1, ?E2, ?Kind, ?Angle) is nondet.
%
%   True when the edges E1 and E2 of the pattern S were one edge of what was
%   unfolded: a `fold` of Angle degrees, positive if convex, where they still
%   are, a `seam` where they were parted. A `line` is a penetration line inside
%   a polygon, whose both directions are E1 and E2.

%!  view(?Theta, ?Phi, ?Rho) is nondet.
%
%   True when the eye is at these spherical coordinates, in degrees.

%!  projection(?Kind) is nondet.
%
%   True when the model is projected so: parallel or central.

%!  title_block(?Item, ?Text) is nondet.
%
%   True when the title block of a sheet says Text, text, a number or an atom,
%   for Item: one of `name number material drawn_by checked_by date company
%   revision sheet`.

%!  span(?Y, ?K, ?X1, ?X2, ?R, ?S, ?F) is nondet.
%
%   True when on line K of row Y of a shaded picture, both counted from 0 from
%   above, face F of leaf S (0: of no segment) of the root R is seen between X1
%   and X2, in 1/256 dot. scan/1 fills it.

%!  look(?S, ?Property) is nondet.
%
%   True when segment S has Property in shaded pictures: colour(C), C a name or
%   rgb(R,G,B).

%!  light(?N, ?Property) is nondet.
%
%   True when light N of shaded pictures has Property: picture(X,Y,Z), it comes
%   from there (to the right, up, towards the eye); direction(X,Y,Z), it goes
%   there in the model; strength(F). Light 0 comes from everywhere.

%!  param(?Name, ?Value) is nondet.
%
%   True when the model has the parameter Name, an atom, and Value is its number
%   now. set_parameter/2 changes it.

%!  param_about(?Name, ?Items) is nondet.
%
%   True when the model says Items of its parameter Name: a list of min(Number),
%   max(Number), step(Number) and text(Language, Text), Language `en` or `ko`.

%!  formula(?Row, ?Fact) is nondet.
%
%   True when Row was made from Fact, the fact as its file has it, with formulas
%   over parameters. Row is segment(S), v(S, V), param(Name), ...: the relation
%   with the key of the row; or the row itself, if it has no key. It holds as
%   long as the values of the formulas are those of the row (formula_rows.pl).
%   Row is set(Name) if the parameter Name was set: Fact has its default.

%!  question(?Name, ?Goal) is nondet.
%
%   True when the model has a question Name; Goal, an atom, is the text of a
%   goal, which is read when it is asked.

%!  screen(?S, ?V, ?Xs, ?Ys, ?Zs) is nondet.
%
%   True when vertex V of segment S is at Xs, Ys in the picture, Zs away.

%!  contour(?S, ?K, ?T, ?I1, ?F1, ?I2, ?F2, ?Visibility, ?Ts, ?X1, ?Y1, ?X2,
%!          ?Y2) is nondet.
%
%   True when piece K of the outline of the smooth surface of segment S runs
%   across triangle T, from F1 on its side I1 to F2 on I2 (contour.pl).
%   Visibility is `hidden` if the surface next to it hides it, `visible` if not,
%   and `substitute` if it is a side of triangles that is drawn where no other
%   line is near. The triangles Ts do not hide it either. In the picture it
%   begins X1 to the right of that place and Y1 above, and ends X2 and Y2 beside
%   the other: there the surface is.

%!  surface_facing(?S, ?T, ?I, ?From, ?To, ?Ts) is nondet.
%
%   True when a line along side I of triangle T of segment S is turned to the
%   eye otherwise than T in the picture, since T stands for a smooth surface
%   (tests/oracle/contour_facing.pl). That surface hides the line from From to
%   To (0.0 at the smaller vertex of the side, 1.0 at the other, in the picture;
%   equal: no part of it), and the triangles Ts do not hide it.

%!  drawn(?D, ?S, ?E, ?From, ?To, ?Visibility, ?Role) is nondet.
%
%   True when part D of the picture is edge E of segment S from From to To (0
%   at its start, 1 at its end); if E is negative, piece -E of contour/13.

/* ---- changing -----------------------------------------------------------

   An argument that is asserted must have its column's type:

     int     an id: an integer from 1 to 2147483647
     float   any number, made a float; finite; -0.0 becomes 0.0
     list    a list of ids
     atom    one of column_domain/3
     term    any ground term of numbers, atoms, strings and compounds

   A world is *whole* when every row that a row refers to is there (the column
   Refers of relation_column/5). What changes it leaves it whole, or is refused:
   inside a transaction anything goes, and its end is refused if the world is
   not whole then. Who retracts a row takes along what rules made from it, the
   rows of derived relations: `t` and `plane` with their polygon, `line`,
   `screen`, `drawn` and so on. A row of v/5, e/5 and p/3 that something else
   refers to goes only with what does, see the option cascade.

   Kernels trust what they read: one that is asked in the middle of a
   transaction first makes the world whole in the same way, or raises an error.
*/

%!  assert_fact(+Fact) is det.
%
%   Adds Fact, as assertz/1 would.
%
%   @error instantiation_error       if Fact is not ground
%   @error existence_error(relation, Name/Arity)
%   @error type_error(Type, Value), domain_error(Domain, Value),
%          representation_error(int32)  if a value does not fit its column
%   @error existence_error(Relation, S-Id)  outside a transaction, if a row
%          that Fact refers to is not there: an edge without its vertex, say.
%          Inside one it may come later, see assert_after/1.
%   @error permission_error(assert, fact, Fact)  if there is a row with the
%          same key already

%!  assert_fact(+Fact, -Row:integer) is det.
%
%   The same; Row is the number of the new row, see fact_row/2.

%!  assert_after(+Fact) is det.
%
%   As assert_fact/1, but the rows that Fact refers to must be there already,
%   inside a transaction too: the error is raised here, and not at its end.

%!  retract_fact(?Fact) is nondet.
%
%   Unifies Fact with a fact and retracts it, as retract/1 does: on
%   backtracking the next one that was there at the call and still is. Rows of
%   derived relations that refer to it go along.
%
%   @error model_error(referred(Fact, Row))  outside a transaction, if another
%          row refers to it

%!  retract_fact(?Fact, +Options) is nondet.
%
%   The same; with the option cascade(true) rows that refer to it are retracted
%   too, whatever they are, and those that refer to them.

retract_fact(Fact, Options) :-
    cascade(Options, Cascade),
    fact_row(Fact, Row),
    functor(Fact, Name, Arity),
    '$retract_row'(Name/Arity, Row, Cascade).

cascade(Options, Cascade) :-
    option(cascade(Cascade), Options, false),
    must_be(boolean, Cascade).

%!  retractall_facts(?Fact) is det.
%
%   Retracts all facts that unify with Fact.
%
%   @error model_error(not_whole(Row, Missing))  outside a transaction, if Row
%          refers to one of them; then all of them stay

/* ---- rows by their number ---------------------------------------------- */

%!  fact_row(?Fact, ?Row:integer) is nondet.
%
%   True when Fact is row number Row of its relation, whose name must be
%   given. A row keeps its number as long as it is there.

%!  edge_polygon(?S, ?E, ?P) is nondet.
%
%   True when edge E is in polygon P of segment S. Given S and E it is found
%   by an index; P in row order.

edge_polygon(S, E, P) :-
    integer(S),
    integer(E),
    !,
    '$edge_polygon'(S, E, P).
edge_polygon(S, E, P) :-
    p(S, P, Es),
    member(E, Es).

%!  vertex_triangle(?S, ?V, ?T) is nondet.
%
%   True when V is a corner of triangle T of segment S. Given S and V it is
%   found by an index; T in row order.

vertex_triangle(S, V, T) :-
    integer(S),
    integer(V),
    !,
    '$vertex_triangle'(S, V, T).
vertex_triangle(S, V, T) :-
    t(S, _, T, V1, V2, V3),
    sort([V1,V2,V3], Vs),
    member(V, Vs).

%!  facts_transaction(:Goal) is semidet.
%
%   Runs Goal once. Its changes stay when it succeeds; when it fails, raises
%   an exception or is interrupted, the world is as it was. Transactions
%   nest; the outermost one that changed anything is one step for
%   facts_undo/0. Other threads see none of its changes before it ends.
%
%   Inside it facts may be asserted and retracted in any order. At the end of
%   the outermost one rows of derived relations that refer to nothing are
%   dropped, and what else was changed is checked.
%
%   @error model_error(not_whole(Row, Missing))  if Row refers to the row
%          Missing, v(S, V) say, that is not there in the end; the world is then
%          as it was

facts_transaction(Goal) :-
    transaction(Goal, false).

%!  facts_transaction(:Goal, +Options) is semidet.
%
%   The same; with the option cascade(true) rows that refer to what Goal has
%   retracted are retracted at its end, instead of an error.

facts_transaction(Goal, Options) :-
    cascade(Options, Cascade),
    transaction(Goal, Cascade).

transaction(Goal, Cascade) :-
    setup_call_cleanup(
        '$begin'(World, Depth),
        (   call(Goal)
        ->  '$commit'(World, Depth, Cascade)
        ),
        '$end'(World, Depth)).

%!  facts_snapshot(:Goal) is semidet.
%
%   Runs Goal once and takes its changes back, also when it succeeds.

facts_snapshot(Goal) :-
    setup_call_cleanup(
        '$begin'(World, Depth),
        once(Goal),
        '$end'(World, Depth)).

%!  facts_undo is semidet.
%
%   Takes back the last outermost transaction that changed something and was
%   not taken back yet, and all changes since outside transactions; fails
%   when there is none. What draw/1 does is one step if the segments cut each
%   other then, and is taken back with the picture. A picture alone and its view
%   are no step: what was done before is taken back, and the picture with it.
%   A world remembers 64 steps, see facts_undo_limit/1.
%
%   @error permission_error(undo, open_transaction, World)

%!  facts_redo is semidet.
%
%   Takes the last facts_undo/0 back; fails when there was none, or when
%   something was changed since.
%
%   @error permission_error(redo, open_transaction, World)

%!  facts_undo_limit(+Steps:integer) is det.
%
%   The current world remembers Steps steps from now on; 0 for none.

/* ---- worlds ------------------------------------------------------------ */

%!  new_world(-World) is det.
%
%   World is a new, empty world. It does not become the current one.

%!  current_world(-World) is det.
%
%   World is the current world of this thread.
%
%   @error existence_error(sg_world, current)

%!  set_world(+World) is det.
%
%   Makes World the current world of this thread.

%!  in_world(+World, :Goal) is semidet.
%
%   Runs Goal once with World as the current world of this thread.

in_world(World, Goal) :-
    '$world'(Old),
    setup_call_cleanup(
        set_world(World),
        once(Goal),
        '$set_world'(Old)).

%!  in_passing_world(:Goal) is semidet.
%
%   Runs Goal once in a new, empty world. When that is over the world is empty
%   again, and its memory free, unless Goal left it to another thread.

in_passing_world(Goal) :-
    new_world(World),
    call_cleanup(in_world(World, Goal), '$spend'(World)).

%!  fresh_id(+Relation, +S, -Id:integer) is det.
%
%   Id is the smallest id above all that were ever used in Relation for
%   segment S, and counts as used from now on. S is ignored for segment, line
%   and drawn. A transaction that rolls back gives its ids back, so doing it
%   again gives the same ones.
%
%   @error domain_error(relation_with_ids, Relation)

%!  segment_stamp(+S, -Stamp:integer) is det.
%
%   Stamp stands for the vertices, edges and polygons of segment S as they are:
%   while it is the same, so are they, and undo brings the old one back. It
%   means nothing in another world. 0: there never were any.

%!  segments_key(+Ss:list, -Key:string) is det.
%
%   Key is equal for equal Ss with equal segment_stamps/2, and for no others: to
%   be compared, not read.

%!  segment_stamps(+Ss:list, -Stamps:list) is det.
%
%   Stamps is the list of S-Stamp for the segments Ss, as segment_stamp/2 has
%   them.

/* ---- the schema -------------------------------------------------------- */

%!  relation(?Name, ?Arity, ?Doc:string) is nondet.
%
%   True when Name/Arity is a relation of the schema.

relation(Name, Arity, Doc) :-
    relation_number(_, Name, Arity, _, Doc).

relation_number(Number, Name, Arity, Key, Doc) :-
    nonvar(Name),
    !,
    '$relation_number'(Name, Number),
    '$relation'(Number, Name, Arity, Key, Doc).
relation_number(Number, Name, Arity, Key, Doc) :-
    '$relation_count'(Count),
    Last is Count-1,
    between(0, Last, Number),
    '$relation'(Number, Name, Arity, Key, Doc).

%!  relation_column(?Relation, ?Position, ?Column, ?Type, ?Refers) is nondet.
%
%   True when the column at Position (from 0, as in engine/relations.def) is
%   called Column; Type is one of int, float, list, atom, term; its ids must
%   be rows of the relation Refers, in the same segment (none: they need not).

relation_column(Relation, Position, Column, Type, Refers) :-
    column(Relation, Position, Column, Type, Refers, _, _).

%!  column_doc(?Relation, ?Position, ?Doc:string) is nondet.
%
%   True when Doc says what the column holds.

column_doc(Relation, Position, Doc) :-
    column(Relation, Position, _, _, _, _, Doc).

%!  column_domain(?Relation, ?Position, -Values:list) is nondet.
%
%   True when the column holds one of Values only.

column_domain(Relation, Position, Values) :-
    column(Relation, Position, _, _, _, Words, _),
    Words \== "",
    split_string(Words, " ", " ", Strings),
    maplist(domain_value, Strings, Values).

domain_value(String, Value) :-
    term_string(Value, String).

column(Relation, Position, Column, Type, Refers, Domain, Doc) :-
    relation_number(Number, Relation, Arity, _, _),
    Last is Arity-1,
    between(0, Last, Position),
    '$column'(Number, Position, Column, Type, Refers, Domain, Doc).

%!  facts_statistics(?Relation, -Statistics:dict) is nondet.
%
%   Statistics is a dict with the rows, slots, bytes and index_bytes of a
%   relation, how many versions of the world are held and what all of them
%   cost of it (version_bytes: which rows they show; `bytes` has that of one),
%   and how often the relation was scanned and looked up by an index.

facts_statistics(Relation,
                 _{rows:Rows, slots:Slots, bytes:Bytes,
                   index_bytes:IndexBytes, version_bytes:VersionBytes,
                   versions:Versions, scans:Scans, lookups:Lookups}) :-
    relation(Relation, _, _),
    '$statistics'(Relation, Rows, Slots, Bytes, IndexBytes, VersionBytes,
                  Versions, Scans, Lookups).

/* ---- sandbox ------------------------------------------------------------

   What only reads is safe in library(sandbox).
*/

:- multifile sandbox:safe_primitive/1.

sandbox:safe_primitive(sg_store:v(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:e(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:p(_,_,_)).
sandbox:safe_primitive(sg_store:plane(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:t(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:leaf_v(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:leaf_e(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:leaf_p(_,_,_)).
sandbox:safe_primitive(sg_store:leaf_t(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:segment(_,_,_)).
sandbox:safe_primitive(sg_store:origin(_,_,_)).
sandbox:safe_primitive(sg_store:from_v(_,_,_,_)).
sandbox:safe_primitive(sg_store:from_p(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:line(_,_,_,_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:gluing(_,_)).
sandbox:safe_primitive(sg_store:unfolding(_,_)).
sandbox:safe_primitive(sg_store:region(_,_,_)).
sandbox:safe_primitive(sg_store:sides(_,_,_,_)).
sandbox:safe_primitive(sg_store:from_r(_,_,_,_)).
sandbox:safe_primitive(sg_store:lies_in(_,_,_)).
sandbox:safe_primitive(sg_store:piece(_,_,_)).
sandbox:safe_primitive(sg_store:joint(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:view(_,_,_)).
sandbox:safe_primitive(sg_store:projection(_)).
sandbox:safe_primitive(sg_store:title_block(_,_)).
sandbox:safe_primitive(sg_store:span(_,_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:look(_,_)).
sandbox:safe_primitive(sg_store:light(_,_)).
sandbox:safe_primitive(sg_store:param(_,_)).
sandbox:safe_primitive(sg_store:param_about(_,_)).
sandbox:safe_primitive(sg_store:formula(_,_)).
sandbox:safe_primitive(sg_store:question(_,_)).
sandbox:safe_primitive(sg_store:screen(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:contour(_,_,_,_,_,_,_,_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:surface_facing(_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:drawn(_,_,_,_,_,_,_)).
sandbox:safe_primitive(sg_store:edge_polygon(_,_,_)).
sandbox:safe_primitive(sg_store:vertex_triangle(_,_,_)).
sandbox:safe_primitive(sg_store:fact_row(_,_)).
sandbox:safe_primitive(sg_store:current_world(_)).
sandbox:safe_primitive(sg_store:segment_stamp(_,_)).
sandbox:safe_primitive(sg_store:segment_stamps(_,_)).
sandbox:safe_primitive(sg_store:segments_key(_,_)).
sandbox:safe_primitive(sg_store:relation(_,_,_)).
sandbox:safe_primitive(sg_store:relation_column(_,_,_,_,_)).
sandbox:safe_primitive(sg_store:column_doc(_,_,_)).
sandbox:safe_primitive(sg_store:column_domain(_,_,_)).
sandbox:safe_primitive(sg_store:facts_statistics(_,_)).
