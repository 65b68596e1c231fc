:- module(sg_kept_picture,
          [ world_picture/2             % +Options, -Image
          ]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../decision', [decision_is_default/1]).
:- use_module('../kernel',
              [image_again/9, image_scanned/6, image_shade/5, shading_scan/5]).
:- use_module('../picture/view', [current_view/4]).
:- use_module('../store', [segment_stamp/2]).
:- use_module(edited_model, [edited_model/5, shaded_state/1]).
:- use_module(group_owner, [owners_asked/3]).
:- use_module(shaded_picture,
              [ empty_picture/3, looks_for_kernel/3, picture_decided/6,
                picture_how/3, picture_place/5 ]).
:- use_module(shading_scene,
              [ facts_dots/5, is_shaded/1, scene_handle/2, scene_tolerance/2,
                shaded_eye/3, shaded_model/2, shaded_scene/5 ]).
:- use_module(surface_look, [scene_looks/4]).
:- use_module(library(apply),
              [exclude/3, foldl/4, foldl/5, maplist/3, maplist/4]).
:- use_module(library(lists),
              [append/3, member/2, nth1/3, reverse/2, same_length/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> The picture of a world that is edited.

The last picture of a thread is kept, with what it was made from. An edit makes
again the bands of rows in which leaves were, or are, that have changed; new
looks make it again from the same spans. The bytes are those of a picture made
afresh in the same frame.
*/

%!  world_picture(+Options, -Image) is det.
%
%   Image is what is seen of the solids of the current world in its view.
%   Options are those of shaded_picture/4 and picture_image/3. As long as
%   Options and the view are the same, the frame stays.
%
%   @error as of shaded_model/2 and shaded_eye/3

world_picture(Options, Image) :-
    shaded_state(State),
    (   kept_picture(Kept),
        edited(Kept, Options, State, Image0)
    ->  Image = Image0
    ;   findall(S, ( root_segment(S), is_shaded(S) ), Roots),
        shaded_model(Roots, Model),
        model_eye(Model, Eye),
        Key = key(Options,Eye,State),
        (   kept_picture(Kept),
            Kept = kept(key(Options,Eye,_),_,_,_,_,_)
        ->  again(Kept, Key, Model, Image)
        ;   afresh(Key, Model, Image)
        )
    ).

%   kept_picture(Kept): of what a rule is asked of groups, or of roots, nothing
%   is kept.

kept_picture(Kept) :-
    decision_is_default(owner/3),
    decision_is_default(may_hide/2),
    nb_current(sg_kept_picture, Kept).

model_eye(Model, Eye) :-
    current_view(Theta, Phi, Rho, Kind),
    shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye).

%   Kept is kept(Key, Frame, Made, Looked, Scan, Image): Key is key(Options,
%   Eye, State), Frame is frame(Size, Place, Tolerance); Made is made(Model,
%   Stamps), those of leaves that are rows; Looked is looked(Looks, Leaves,
%   How), for the kernel; Scan is scan(Scene, Spans), or `none`.

%   edited(Kept, Options, State, Image): only some primitives are others.

edited(kept(key(Options0,Eye,State0),frame(Size,Place,Tolerance),
            made(Model0,Stamps),Looked,_,Image0),
       Options, State, Image) :-
    Options0 == Options,
    may_be_parts(Looked, Looked),
    edited_model(State0, State, Model0, Model, Changed),
    model_eye(Model, Eye1),
    Eye1 == Eye,
    (   Changed == []
    ->  Image = Image0
    ;   shaded_scene(Model, Eye, Place, Size, Scene),
        scene_tolerance(Scene, Tolerance),
        shaded_again(Image0, Changed, Scene, Eye, Place, Size, Looked, Image),
        nb_setval(sg_kept_picture,
                  kept(key(Options,Eye,State),frame(Size,Place,Tolerance),
                       made(Model,Stamps),Looked,none,Image))
    ).

%   shaded_again(Image0, Changed, Scene, Eye, Place, Size, Looked, Image):
%   Image0 where none of the facts Changed is.

shaded_again(Image0, Changed, Scene, Eye, Place, Size,
             looked(Looks,Leaves,How), Image) :-
    findall(Box, ( member(Fact, Changed),
                   facts_dots(Eye, Place, Size, [Fact], Box) ),
            Boxes),
    changed_bands(Boxes, Size, Bands),
    changed_columns(Boxes, Size, From, To),
    scene_handle(Scene, Handle),
    image_again(Image0, Bands, From, To, Handle, How, Looks, Leaves, Image).

afresh(Key, Model, Image) :-
    Key = key(Options,Eye,_),
    (   picture_place(Model, Eye, Options, Size, Place)
    ->  shaded_scene(Model, Eye, Place, Size, Scene),
        looked(Scene, Options, Looked),
        scanned(Key, Size-Place, Model, Scene, Looked, Image)
    ;   empty_picture(Eye, Options, Scene),
        looked(Scene, Options, looked(Looks,Leaves,How)),
        scene_handle(Scene, Handle),
        image_shade(Handle, How, Looks, Leaves, Image),
        nb_setval(sg_kept_picture, none)
    ).

looked(Scene, Options, looked(Looks,Leaves,How)) :-
    option(colours(Colours), Options, root),
    scene_looks(Scene, Colours, Looks0, Leaves),
    looks_for_kernel(Looks0, Options, Looks),
    picture_how(Scene, Options, How).

%   scanned(Key, Size-Place, Model, Scene, Looked, Image): all of it, and its
%   spans are kept.

scanned(Key, Framed, Model, Scene, Looked, Image) :-
    Looked = looked(Looks,Leaves,How),
    How = how(Lines,_,_,Shadows),
    maplist(kernel_opacity, Looks, Opacities),
    scene_handle(Scene, Handle),
    owners_asked(Scene, Shadows,
                 ( shading_scan(Handle, Lines, Opacities, Leaves, Spans),
                   image_scanned(Spans, Handle, How, Looks, Leaves, Image) )),
    kept(Key, Framed, Model, Scene, Looked, scan(Scene,Spans), Image).

kernel_opacity(look(_,_,A,_,_), A).

%   kept(Key, Size-Place, Model, Scene, Looked, Scan, Image): for the next
%   time; then Image gets what rules, and a palette, change in it.

kept(Key, Size-Place, Model, Scene, Looked, Scan, Image) :-
    Looked = looked(Looks,Leaves,How),
    Key = key(Options,_,_),
    (   decision_is_default(pixel_colour/4),
        decision_is_default(owner/3),
        decision_is_default(may_hide/2),
        \+ option(palette(_), Options)
    ->  scene_tolerance(Scene, Tolerance),
        row_stamps(Model, Stamps),
        nb_setval(sg_kept_picture,
                  kept(Key,frame(Size,Place,Tolerance),made(Model,Stamps),
                       Looked,Scan,Image))
    ;   nb_setval(sg_kept_picture, none)
    ),
    picture_decided(Scene, How, Looks, Leaves, Options, Image).

%   again(Kept, Key, Model, Image)

again(kept(_,frame(Size,Place,Tolerance),made(Model0,Stamps0),Looked0,Scan0,
           Image0),
      Key, Model, Image) :-
    Key = key(Options,Eye,_),
    shaded_scene(Model, Eye, Place, Size, Scene),
    looked(Scene, Options, Looked),
    things(Model0, Stamps0, Things0),
    row_stamps(Model, Stamps),
    things(Model, Stamps, Things),
    (   same_solids(Model0-Things0, Model-Things)
    ->  other_looks(Scan0, Looked0, Looked, Key, Size-Place, Model, Scene,
                    Image0, Image)
    ;   scene_tolerance(Scene, Tolerance),
        may_be_parts(Looked0, Looked),
        changed(Model0, Things0, Looked0, Model, Things, Looked, Facts)
    ->  shaded_again(Image0, Facts, Scene, Eye, Place, Size, Looked, Image),
        kept(Key, Size-Place, Model, Scene, Looked, none, Image)
    ;   scanned(Key, Size-Place, Model, Scene, Looked, Image)
    ).

%   other_looks(...): the spans are the same, if what is see-through is.

other_looks(scan(Scene0,Spans), Looked0, Looked, Key, Framed, Model, _, Image0,
            Image) :-
    same_opacities(Looked0, Looked),
    !,
    (   same_looks(Looked0, Looked)
    ->  Image = Image0
    ;   Looked = looked(Looks,Leaves,How),
        scene_handle(Scene0, Handle),
        image_scanned(Spans, Handle, How, Looks, Leaves, Image),
        kept(Key, Framed, Model, Scene0, Looked, scan(Scene0,Spans), Image)
    ).
other_looks(none, Looked0, Looked, _, _, _, _, Image, Image) :-
    same_looks(Looked0, Looked),
    !.
other_looks(_, _, Looked, Key, Framed, Model, Scene, _, Image) :-
    scanned(Key, Framed, Model, Scene, Looked, Image).

same_opacities(looked(Looks0,Leaves0,_), looked(Looks,Leaves,_)) :-
    maplist(kernel_opacity, Looks0, Opacities0),
    maplist(kernel_opacity, Looks, Opacities),
    (   \+ ( member(A, Opacities0), A < 1 ),
        \+ ( member(A, Opacities), A < 1 )
    ->  true
    ;   Opacities0 == Opacities,
        Leaves0 == Leaves
    ).

%   Scenes of lights are new ones each time, of the same solids and lights.

same_looks(looked(Looks,Leaves,how(Lines,Background,Edges,Shadows0)),
           looked(Looks1,Leaves1,how(Lines1,Background1,Edges1,Shadows))) :-
    Looks-Leaves == Looks1-Leaves1,
    Lines-Background-Edges == Lines1-Background1-Edges1,
    length(Shadows0, N),
    length(Shadows, N).

%   may_be_parts(Looked0, Looked): a shadow may fall anywhere.

may_be_parts(looked(Looks0,_,How0), looked(Looks,_,How)) :-
    Looks0 == Looks,
    How0 == How,
    How = how(_,_,_,[]).


                /*******************************
                *            CHANGES           *
                *******************************/

%   row_stamps(Model, Stamps): those of the segments whose rows are leaves of
%   the kernel, in their order.

row_stamps(model(_,Facts,_), Stamps) :-
    findall(Stamp, ( member(rows(_,S,_), Facts), segment_stamp(S, Stamp) ),
            Stamps).

%   things(Model, Stamps, Things): what each leaf of the kernel is: thing(What,
%   Stamp), without numbers, which edits shift. Rows have the stamp of their
%   segment.

things(model(_,Facts,_), Stamps, Things) :-
    foldl(thing, Facts, Things, Stamps, []).

thing(Fact, thing([Name|What],Stamp), Stamps0, Stamps) :-
    Fact =.. [Name,_|What],
    (   Name == rows
    ->  Stamps0 = [Stamp|Stamps]
    ;   Stamp = 0,
        Stamps = Stamps0
    ).

same_solids(model(Leaves0,_,Roots0)-Things0, model(Leaves,_,Roots)-Things) :-
    Things0 == Things,
    Roots0 == Roots,
    same_length(Leaves0, Leaves).

%   changed(Model0, Things0, Looked0, Model, Things, Looked, Facts): where none
%   of Facts is, before or after, the two are the same.

changed(model(_,Facts0,Roots0), Things0, looked(_,Leaves0,_),
        model(_,Facts,Roots), Things, looked(_,Leaves,_), Changed) :-
    dressed(Facts0, Things0, Leaves0, Dressed0),
    dressed(Facts, Things, Leaves, Dressed),
    matched(Dressed0, Dressed, Names0, Names),
    reduced_roots(Roots0, Names0, Reduced),
    reduced_roots(Roots, Names, Reduced1),
    Reduced == Reduced1,
    findall(Fact, changed_fact(Names0, Facts0, Fact), Changed0),
    findall(Fact, changed_fact(Names, Facts, Fact), Changed1),
    append(Changed0, Changed1, Changed).

%   dressed(Facts, Things, Leaves, Dressed): each thing with its looks.

dressed(Facts, Things, Leaves, Dressed) :-
    compound_name_arguments(Of, leaves, Leaves),
    maplist(dressed_thing(Of), Facts, Things, Dressed).

dressed_thing(Of, Fact, Thing, Looks-Thing) :-
    arg(1, Fact, Number),
    arg(Number, Of, Looks).

%   matched(Dressed0, Dressed, Names0, Names): those that are the same have one
%   name, a number; others have 0. As many as before are one by one; else they
%   begin alike and end alike.

matched(Dressed0, Dressed, Names0, Names) :-
    same_length(Dressed0, Dressed),
    !,
    one_by_one(Dressed0, Dressed, 1, Names0),
    Names = Names0.
matched(Dressed0, Dressed, Names0, Names) :-
    begin_alike(Dressed0, Dressed, 1, Names0, Names, Next, Rest0-End0,
                Rest-End),
    reverse(Rest0, Back0),
    reverse(Rest, Back),
    begin_alike(Back0, Back, Next, Last0, Last, _, Middle0-Tail0, Middle-Tail),
    maplist(zero, Middle0, Tail0),
    maplist(zero, Middle, Tail),
    reverse(Last0, End0),
    reverse(Last, End).

one_by_one([], [], _, []).
one_by_one([D0|Dressed0], [D|Dressed], I, [Name|Names]) :-
    (   D0 == D
    ->  Name = I
    ;   Name = 0
    ),
    J is I+1,
    one_by_one(Dressed0, Dressed, J, Names).

begin_alike([D0|Dressed0], [D|Dressed], I, [I|Names0], [I|Names], Next, Rest0,
            Rest) :-
    D0 == D,
    !,
    J is I+1,
    begin_alike(Dressed0, Dressed, J, Names0, Names, Next, Rest0, Rest).
begin_alike(Dressed0, Dressed, I, End0, End, I, Dressed0-End0, Dressed-End).

zero(_, 0).

changed_fact(Names, Facts, Fact) :-
    nth1(I, Names, 0),
    nth1(I, Facts, Fact).

%   reduced_roots(Roots, Names, Reduced): the trees where none of the leaves
%   without a name is there.

reduced_roots(Roots, Names0, Reduced) :-
    compound_name_arguments(Names, names, Names0),
    findall(root(S,Tree),
            ( member(root(S,Nodes), Roots),
              reduced(Nodes, [], Names, Tree),
              Tree \== nothing ),
            Reduced).

reduced([node(leaf,Place)|Nodes], Nodes, Names, Tree) :-
    !,
    arg(Place, Names, Name),
    (   Name =:= 0
    ->  Tree = nothing
    ;   Tree = Name
    ).
reduced([node(Operation,Count)|Nodes0], Nodes, Names, Tree) :-
    operands_reduced(Count, Nodes0, Nodes, Names, Trees),
    reduced_operation(Operation, Trees, Tree).

operands_reduced(0, Nodes, Nodes, _, []) :-
    !.
operands_reduced(Count, Nodes0, Nodes, Names, [Tree|Trees]) :-
    reduced(Nodes0, Nodes1, Names, Tree),
    Fewer is Count-1,
    operands_reduced(Fewer, Nodes1, Nodes, Names, Trees).

reduced_operation(intersection, Trees, Tree) :-
    !,
    (   memberchk(nothing, Trees)
    ->  Tree = nothing
    ;   one_or(intersection, Trees, Tree)
    ).
reduced_operation(difference, [First|Others0], Tree) :-
    !,
    (   First == nothing
    ->  Tree = nothing
    ;   exclude(==(nothing), Others0, Others),
        one_or(difference, [First|Others], Tree)
    ).
reduced_operation(Operation, Trees0, Tree) :-
    exclude(==(nothing), Trees0, Trees),
    (   Trees == []
    ->  Tree = nothing
    ;   one_or(Operation, Trees, Tree)
    ).

one_or(Operation, Trees, Tree) :-
    (   Trees = [Only]
    ->  Tree = Only
    ;   Tree = node(Operation,Trees)
    ).

%   changed_bands(Boxes, Size, Bands): a line between faces reaches half a dot
%   farther than these.

changed_bands(Boxes, _-Height, Bands) :-
    Last is Height-1,
    findall(Band,
            ( member(b(_,Y1,_,Y2), Boxes),
              First is max(0, floor(Y1) - 1),
              End is min(Last, ceiling(Y2) + 1),
              First =< End,
              From is First//16,
              To is End//16,
              between(From, To, Band) ),
            Bands0),
    sort(Bands0, Bands).

%   changed_columns(Boxes, Size, From, To): from, and up to, not with, those of
%   all Boxes. Beside the picture there is one.

changed_columns(Boxes, Width-_, From, To) :-
    foldl(wider, Boxes, Width-0, X1-X2),
    From is max(0, min(Width-1, floor(X1) - 2)),
    To is max(From+1, min(Width, ceiling(X2) + 2)).

wider(b(X1,_,X2,_), From0-To0, From-To) :-
    From is min(From0, X1),
    To is max(To0, X2).
