:- module(sg_shading_section,
          [ may_section/2,              % +S, +Plane
            sectioned_model/3           % +Planes, +Model0, -Model
          ]).
:- use_module('../decision', [decision/2]).
:- use_module('../kernel', [shading_box/3]).
:- use_module(shading_half, [half_leaf/3]).
:- use_module(library(apply), [foldl/4]).
:- use_module(library(assoc), [get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists), [append/3, last/2, member/2]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Shaded pictures that are cut open.

A section is one more leaf of each root: what is behind the plane, with which
the root is intersected. Its face in the plane is the only one that is ever
seen.
*/

:- decision(may_section/2, "Which solids a section of a shaded picture cuts").

%!  may_section(+S, +Plane) is semidet.
%
%   True when a section in Plane = plane(A, B, C, D) cuts the root S open. A
%   decision: what drawings do not cut, such as shafts, bolts, ribs (ISO 128-3),
%   a rule may keep whole.

may_section(_, _).

%!  sectioned_model(+Planes, +Model0, -Model) is semidet.
%
%   Model is Model0 (shading_scene.pl) without what is above each of Planes.
%   Fails if a plane cuts no root.

sectioned_model(Planes, Model0, Model) :-
    foldl(plane_cut, Planes, Model0, Model).

plane_cut(Plane, Model0, model(Leaves,Facts,Roots)) :-
    Model0 = model(Leaves0,Facts0,Roots0),
    root_facts(Leaves0, Facts0, ByRoot),
    length(Facts0, Places),
    (   last(Leaves0, leaf(Last,_,_,_,_))
    ->  true
    ;   Last = 0
    ),
    roots_cut(Roots0, Plane, ByRoot, Last, Places, Roots, Cuts),
    Cuts = [_|_],
    findall(Leaf, member(Leaf-_, Cuts), MoreLeaves),
    findall(Fact, member(_-Fact, Cuts), MoreFacts),
    append(Leaves0, MoreLeaves, Leaves),
    append(Facts0, MoreFacts, Facts).

%   root_facts(Leaves, Facts, ByRoot): assoc from a root to what its leaves are.

root_facts(Leaves, Facts, ByRoot) :-
    findall(Number-Root, member(leaf(Number,Root,_,_,_), Leaves), Roots),
    list_to_assoc(Roots, RootOf),
    findall(Root-Fact,
            ( member(Fact, Facts), arg(1, Fact, Number),
              get_assoc(Number, RootOf, Root) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    list_to_assoc(Groups, ByRoot).

%   roots_cut(Roots0, Plane, ByRoot, Number, Place, Roots, Cuts): Cuts are
%   Leaf-Fact, of numbers behind Number and Place.

roots_cut([], _, _, _, _, [], []).
roots_cut([Root0|Roots0], Plane, ByRoot, Number0, Place0, [Root|Roots], Cuts) :-
    Root0 = root(S,Nodes),
    (   may_section(S, Plane),
        get_assoc(S, ByRoot, Facts),
        root_half(Plane, Facts, Half),
        Half \== all
    ->  half_cut(Half, S, Nodes, Number0, Place0, Number, Place, Root, Cuts,
                 Cuts1)
    ;   Root = Root0,
        Number = Number0,
        Place = Place0,
        Cuts = Cuts1
    ),
    roots_cut(Roots0, Plane, ByRoot, Number, Place, Roots, Cuts1).

root_half(Plane, Facts, Half) :-
    shading_box(frame([ 1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, 0.0,0.0,1.0,0.0,
                        0.0,0.0,0.0,1.0 ], 1, 1, 0.0), Facts, Box),
    half_leaf(Plane, Box, Half).

half_cut(none, S, _, Number, Place, Number, Place, root(S,[node(union,0)]),
         Cuts, Cuts).
half_cut(flat(Points,[],Polygons), S, Nodes, Number0, Place0, Number, Place,
         root(S,[node(intersection,2),node(leaf,Place)|Nodes]),
         [Leaf-flat(Number,Points,[],Polygons)|Cuts], Cuts) :-
    Number is Number0+1,
    Place is Place0+1,
    Leaf = leaf(Number,S,0,section,[1-section]).
