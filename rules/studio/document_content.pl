:- module(sg_document_content,
          [ text_digest/2,              % +Text, -Digest
            content_key/3,              % +Text, +Rules, -Key
            content/3,                  % +Key, -Text, -Rules
            contents_swept/1,           % +State
            model_world/5,              % +Kind, +File, +Key, -World, -Objects
            file_world_forgotten/1      % +File
          ]).
:- use_module('../decision', [use_rules_of/2]).
:- use_module('../message/message_object', [objects_heard/2]).
:- use_module('../model/model', [load_model/1]).
:- use_module('../store',
              [facts_statistics/2, in_world/2, new_world/1]).
:- use_module(job, [with_input/2]).
:- use_module(world_state,
              [ world_begun/1, world_forgotten/1, world_is_known/1 ]).
:- use_module(library(aggregate), [aggregate_all/3]).
:- use_module(library(lists), [append/3, member/2]).
:- use_module(library(ordsets), [ord_subtract/3]).
:- use_module(library(sha), [sha_hash/3, hash_atom/2]).
/** <module> The texts that a document had, with their rules, and the worlds of
the last of them.

What the model of a text is does not depend on the way to it, so a text that
comes again, as undo brings it, finds its world again.
*/

% content_(Key, Text, Rules): Rules "" are none. kept_world(Key, World, Objects,
% Octets): the last used one comes last; Octets are what it had when another one
% was used next. used(Key): the last used one.
:- dynamic content_/3, kept_world/4, used/1.

%   most_octets(N): of the worlds that are kept to go back to, by their
%   relations; fewest_worlds(N): are kept whatever they have, those of rules and
%   of others that are tried; least_octets(N): has a world for certain.
%   most_contents(N): kept to go back to.

most_octets(140 000 000).
fewest_worlds(2).
least_octets(250 000).
most_contents(1256).

%!  text_digest(+Text, -Digest:atom) is det.

text_digest(Text, Digest) :-
    sha_hash(Text, Hash, [algorithm(sha256), encoding(utf8)]),
    hash_atom(Hash, Digest).

%!  content_key(+Text, +Rules, -Key:atom) is det.
%
%   Key is that of these from now on: without rules, the digest of the text.

content_key(Text, Rules, Key) :-
    text_digest(Text, Of),
    (   Rules == ""
    ->  Key = Of
    ;   text_digest(Rules, By),
        atomic_list_concat([Of,+,By], Key)
    ),
    (   content_(Key, _, _)
    ->  true
    ;   assertz(content_(Key, Text, Rules))
    ).

%!  content(+Key, -Text, -Rules) is semidet.

content(Key, Text, Rules) :-
    content_(Key, Text0, Rules0),
    !,
    Text = Text0,
    Rules = Rules0.

%!  contents_swept(+State) is det.
%
%   When there are too many, those are gone that nobody goes back to: that are
%   not in State, which is state(Now, Past, Future).

contents_swept(state(Now, Past, Future)) :-
    most_contents(Most),
    predicate_property(content_(_, _, _), number_of_clauses(N)),
    (   N > Most
    ->  append([Now|Past], Future, Keys0),
        sort(Keys0, Keys),
        findall(Key, content_(Key, _, _), All0),
        sort(All0, All),
        ord_subtract(All, Keys, Gone),
        forall(member(Key, Gone), retractall(content_(Key, _, _)))
    ;   true
    ).

%!  model_world(+Kind, +File, +Key, -World, -Objects) is det.
%
%   World holds the model that is in File, if Kind is `other`, or else that of
%   the text with this Key, by its rules. Objects are the messages of loading.
%
%   @error model_error(What)

model_world(Kind, File, Key, World, Objects) :-
    used_before(Key, Another),
    (   retract(kept_world(Key, World0, Objects0, Octets0)),
        world_is_known(World0)
    ->  World = World0,
        Objects = Objects0,
        Octets = Octets0
    ;   new_world(World),
        in_world(World, objects_heard(model_loaded(Kind, File, Key),
                                      Objects)),
        world_begun(World),
        least_octets(Octets)
    ),
    assertz(kept_world(Key, World, Objects, Octets)),
    (   Another == true
    ->  retractall(used(_)),
        assertz(used(Key)),
        forget_worlds
    ;   true
    ).

%   used_before(Key, Another): Another is true if the last used world is not
%   that of Key; what it has is known from now on.

used_before(Key, Another) :-
    (   used(Key)
    ->  Another = false
    ;   Another = true,
        (   used(Before),
            retract(kept_world(Before, World, Objects, _))
        ->  world_octets(World, Octets),
            assertz(kept_world(Before, World, Objects, Octets))
        ;   true
        )
    ).

world_octets(World, Octets) :-
    in_world(World,
             aggregate_all(sum(Of), relation_octets(Of), Octets0)),
    least_octets(Least),
    Octets is max(Least, Octets0).

relation_octets(Octets) :-
    facts_statistics(_, Statistics),
    Octets is Statistics.bytes+Statistics.index_bytes+Statistics.version_bytes.

%   A text is read as if it came from standard input.

model_loaded(other, File, _) :-
    load_model(File).
model_loaded(text, _, Key) :-
    content_(Key, Text, Rules),
    (   Rules == ""
    ->  true
    ;   with_input(Rules, use_rules_of(-, rules))
    ),
    with_input(Text, load_model(-)).

forget_worlds :-
    most_octets(Most),
    fewest_worlds(Fewest),
    aggregate_all(r(count, sum(Octets)), kept_world(_, _, _, Octets),
                  r(N, All)),
    (   N > Fewest,
        All > Most,
        retract(kept_world(_, World, _, _))
    ->  world_forgotten(World),
        forget_worlds
    ;   true
    ).

%!  file_world_forgotten(+File) is det.
%
%   File is read again, if it is asked for.

file_world_forgotten(File) :-
    forall(retract(kept_world(file(File), World, _, _)),
           world_forgotten(World)).
