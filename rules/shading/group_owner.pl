:- module(sg_group_owner,
          [ group_owner/5,              % +Scene, +R, +Mets, -Leaf, -F
            owners_asked/2,             % +Scene, :Goal
            owners_asked/3              % +Scene, +Others, :Goal
          ]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../kernel', [shading_groups/2, shading_owners/2]).
:- use_module(face_owner, [owner/3]).
:- use_module(shading_scene, [named_face/3, scene_handle/2, scene_leaf/2]).
:- use_module(library(apply), [maplist/2, maplist/3]).
:- use_module(library(lists), [member/2, nth0/3]).
:- use_module(library(pairs), [pairs_values/2]).
/** <module> Whom the groups of a shaded picture are asked: owner/3.

A kernel cannot ask a rule. It notes the groups that it meets and that have no
answer; they are asked here, each once, and what it did is done again.
*/

%!  group_owner(+Scene, +R, +Mets, -Leaf, -F) is det.
%
%   Of Mets, one or more Leaf-F as of shading_groups/2, ascending, the face F of
%   leaf number Leaf is seen.

group_owner(_, _, [Leaf-F], Leaf, F) :-
    !.
group_owner(Scene, R, Mets, Leaf, F) :-
    named_leaves(Scene, Named),
    owner_place(Named, group(R,_,Mets), I),
    nth0(I, Mets, Leaf-F).

%   named_leaves(Scene, Named): a compound of leaf(S, Faces), by Number.

named_leaves(Scene, Named) :-
    findall(leaf(S,Faces), scene_leaf(Scene, leaf(_,_,S,_,Faces)), Leaves),
    compound_name_arguments(Named, leaves, Leaves).

%   owner_place(Named, Group, I): its I-th face, from 0, is seen.

owner_place(Named, group(R,_,Mets), I) :-
    maplist(named_met(Named), Mets, Group),
    (   owner(R, Group, Owner),
        nth0(I0, Group, Owner)
    ->  I = I0
    ;   I = 0
    ).

named_met(Named, Leaf-F, S-Face) :-
    arg(Leaf, Named, leaf(S,Faces)),
    named_face(F, Faces, Face).

%!  owners_asked(+Scene, :Goal) is semidet.
%!  owners_asked(+Scene, +Others, :Goal) is semidet.
%
%   Calls Goal, once, as if the kernel asked owner/3 while it runs: Goal looks
%   at the handle of Scene, and at Others, those of other pictures of its model.
%   It may be called several times; the last one counts.

:- meta_predicate
    owners_asked(+, 0),
    owners_asked(+, +, 0).

owners_asked(Scene, Goal) :-
    owners_asked(Scene, [], Goal).

owners_asked(Scene, Others, Goal) :-
    (   decision_is_default(owner/3)
    ->  once(Goal)
    ;   scene_handle(Scene, Handle),
        called_until_answered(Scene, [Handle|Others], Goal)
    ).

called_until_answered(Scene, Handles, Goal) :-
    copy_term(Goal, Copy),
    (   call(Copy)
    ->  Called = true
    ;   Called = false
    ),
    findall(Handle-Groups,
            ( member(Handle, Handles),
              shading_groups(Handle, Groups),
              Groups \== [] ),
            Asked),
    (   Asked == []
    ->  Called == true,
        Goal = Copy
    ;   named_leaves(Scene, Named),
        maplist(groups_answered(Named), Asked),
        called_until_answered(Scene, Handles, Goal)
    ).

%   groups_answered(Named, Handle-Groups): asked in the order of what they are,
%   whichever was met first.

groups_answered(Named, Handle-Groups) :-
    findall(Group-I, nth0(I, Groups, Group), Numbered0),
    keysort(Numbered0, Numbered),
    findall(I-Owner,
            ( member(Group-I, Numbered), owner_place(Named, Group, Owner) ),
            Answers0),
    keysort(Answers0, Answers),
    pairs_values(Answers, Owners),
    shading_owners(Handle, Owners).
