:- module(sg_explain_pixel,
          [ pixel_because/4,            % +X, +Y, +Options, -Because
            unseen_because/3            % +S, +Options, -Because
          ]).
:- use_module(explain_pair, [decided_by/2]).
:- use_module(explain_tree, [tree_way/3, false_reason/4, takes_away/1]).
:- use_module('../csg/csg', [root_segment/1]).
:- use_module('../colour', [colour_rgb/2]).
:- use_module('../kernel',
              [ image_dot/4, shading_layers/4, shading_place/5,
                shading_point/6, srgb_light/2 ]).
:- use_module('../picture/view', [current_view/4]).
:- use_module('../shading/seen', [met/4, seen_layers/4, slice/3]).
:- use_module('../shading/shaded_picture',
              [picture_image/3, shaded_picture/4]).
:- use_module('../shading/shading_scene',
              [ scene_handle/2, scene_leaf/2, scene_place/2, scene_root/2,
                scene_size/2, shaded_eye/3, shaded_model/2 ]).
:- use_module('../shading/surface_look',
              [ look_opacity/2, look_source/4, scene_looks/4,
                scene_opacities/2 ]).
:- use_module('../shading/surface_ramp', [ramp/3]).
:- use_module('../shading/surface_tone',
              [look_shine/2, picture_normal/2, tone/3, tone_sum/3]).
:- use_module('../store', [segment/3]).
:- use_module(library(apply), [foldl/4, maplist/2, maplist/3]).
:- use_module(library(lists),
              [append/2, append/3, member/2, nth0/3, nth1/3, sum_list/2]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(ordsets), [ord_symdiff/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).

/** <module> Explain: why a dot of a shaded picture has its colour (CB-7, CB-8).

The definition (seen.pl) runs again for the one line of sight: what it meets,
group by group, which leaf each group enters or leaves, and why the tree of the
root does not hold there yet. Then the decisions about looks say how the face is
shown. The bytes of a dot are those of the picture itself.

Options are those of shaded_picture/4 and picture_image/3 that the picture was
made with, or scene(Scene).
*/

%!  pixel_because(+X, +Y, +Options, -Because) is semidet.
%
%   Because says why the dot X of row Y, counted from 0 from the upper left, has
%   its colour. Fails if the picture has no such dot.

pixel_because(X, Y, Options, [because(pixel(X,Y,Bytes), Because)]) :-
    integer(X),
    integer(Y),
    picture_scene(Options, Scene),
    scene_size(Scene, Width-Height),
    X >= 0, X < Width,
    Y >= 0, Y < Height,
    picture_image(Scene, Options, Image),
    image_dot(Image, X, Y, Bytes),
    option(smooth(Lines), Options, 4),
    All is 256*Lines,
    scene_opacities(Scene, Opaque),
    dot_parts(Scene, X, Y, Lines, Opaque, Parts),
    option(colours(Colours), Options, root),
    scene_looks(Scene, Colours, Looks, Leaves),
    maplist(part_because(seen(Scene,X,Y,All,Options,Looks,Leaves)), Parts,
            Seen),
    background_because(Parts, All, Options, Rest),
    append(Seen, Rest, Because).

picture_scene(Options, Scene) :-
    (   option(scene(Scene0), Options)
    ->  Scene = Scene0
    ;   findall(S, ( root_segment(S), segment(S, solid, _) ), Roots),
        shaded_model(Roots, Model),
        current_view(Theta, Phi, Rho, Kind),
        shaded_eye(Model, view(Theta,Phi,Rho,Kind), Eye),
        shaded_picture(Model, Eye, Options, Scene)
    ).

%   dot_parts(Scene, X, Y, Lines, Opaque, Parts): part(Share, R, Leaf, F, Z,
%   At), the largest first: of all lines face F has so many 1/256 dots, each
%   counted as much as its light comes from that face; At is X1-Y1, in the
%   middle of the widest piece, where it has the depth Z. Opaque is as of
%   scene_opacities/2.

dot_parts(Scene, X, Y, Lines, Opaque, Parts) :-
    Last is Lines-1,
    findall(seen(R,Leaf,F,Nth)-piece(Share,X1,Y1,Z),
            ( between(0, Last, K),
              Y1 is Y + (K+0.5)/Lines,
              dot_cell(Scene, X, Y1, Opaque, A, B),
              X1 is (A+B)/512.0,
              seen_layers(Scene, X1, Y1, Layers),
              layer_shares(Layers, Opaque, 1.0, [], Shares),
              member(share(Z,R,Leaf,F,Nth,Part), Shares),
              Share is (B-A)*Part ),
            Pieces0),
    keysort(Pieces0, Pieces),
    group_pairs_by_key(Pieces, Groups),
    findall(Sum-part(Sum,R,Leaf,F,Z,X1-Y1),
            ( member(seen(R,Leaf,F,_)-Own, Groups),
              findall(S, member(piece(S,_,_,_), Own), Ss),
              sum_list(Ss, Sum),
              sort(1, @>=, Own, [piece(_,X1,Y1,Z)|_]) ),
            Parts0),
    sort(1, @>=, Parts0, Sorted),
    pairs_values(Sorted, Parts).

%   dot_cell(Scene, X, Y, Opaque, A, B): between A and B, in 1/256 dot, the same
%   is seen on the line Y through dot X.

dot_cell(Scene, X, Y, Opaque, A, B) :-
    scene_handle(Scene, Handle),
    shading_layers(Handle, Y, Opaque, Layers),
    Left is 256*X,
    Right is Left+256,
    findall(End,
            ( member(layer(X1,X2,_,_,_,_), Layers),
              member(End, [X1,X2]),
              End > Left,
              End < Right ),
            Ends),
    sort([Left,Right|Ends], Cuts),
    append(_, [A,B|_], Cuts).

%   layer_shares(Layers, Opaque, Left, Before, Shares): Shares are share(Z, R,
%   Leaf, F, Nth, Part) of those of Layers (seen_layers/4) that light comes
%   from: the Nth layer of that face has that Part of it, as long as something
%   is Left.

layer_shares([], _, _, _, []).
layer_shares([layer(Z,R,Leaf,F)|Layers], Opaque, Left0, Before, Shares) :-
    face_opacity(Opaque, Leaf, F, A),
    Part is Left0*A,
    Left is Left0-Part,
    findall(F, member(Leaf-F, Before), Same),
    length(Same, Nth),
    (   Part > 0
    ->  Shares = [share(Z,R,Leaf,F,Nth,Part)|Shares1]
    ;   Shares = Shares1
    ),
    (   Left > 0
    ->  layer_shares(Layers, Opaque, Left, [Leaf-F|Before], Shares1)
    ;   Shares1 = []
    ).

face_opacity(Opaque, Leaf, F, A) :-
    nth1(Leaf, Opaque, Own),
    (   nth0(F, Own, A0)
    ->  A = A0
    ;   Own = [A|_]
    ).

background_because(Parts, All, Options, Because) :-
    findall(C, member(part(C,_,_,_,_,_), Parts), Cs),
    sum_list(Cs, Covered),
    (   Covered < All
    ->  Percent is 100.0*(All-Covered)/All,
        option(background(Colour), Options, white),
        Because = [because(background_part(Percent,Colour), [])]
    ;   Because = []
    ).

%   part_because(Seen, Part, Because)

part_because(seen(Scene,X,Y,All,Options,Looks,Leaves),
             part(Covered,R,Leaf,F,Z,X1-Y1),
             because(seen_part(Percent,What,Leaf,S,Name,R), Because)) :-
    Percent is 100.0*Covered/All,
    leaf_names(Scene, Leaf, F, What, S, Name),
    walked(Scene, X1, Y1, Z, Walk),
    place_because(Scene, X1, Y1, Walk, Place),
    tree_because(Scene, Leaf, Walk, Tree),
    before_because(Scene, X1, Y1, Walk, Before),
    nth1(Leaf, Leaves, Places),
    (   nth0(F, Places, LookPlace)
    ->  true
    ;   Places = [LookPlace|_]
    ),
    nth0(LookPlace, Looks, Look),
    behind_because(Scene, X1, Y1, Walk, Look, Behind),
    option(colours(Colours), Options, root),
    look_because(R, S, Colours, Look, LookWhy),
    option(shade(Shade), Options, lambert),
    side_normal(Scene, X, Y, X1-Y1, part(R,Leaf,F), Walk, Normal),
    tone_because(Normal, [shade(Shade)|Look], ToneWhy),
    append([Place,Tree,Before,Behind,LookWhy,ToneWhy], Because).

%   leaf_names(Scene, Leaf, F, What, S, Name): What the face F is of leaf number
%   Leaf, which is a Name, of segment S, or 0.

leaf_names(Scene, Leaf, F, What, S, Name) :-
    once(scene_leaf(Scene, leaf(Leaf,_,S,Term,Faces))),
    (   memberchk(F-What0, Faces)
    ->  What = What0
    ;   What = polygon(F)
    ),
    (   Term == rows,
        S > 0
    ->  segment(S, _, Of)
    ;   Of = Term
    ),
    bare_name(Of, Name).

bare_name(at(_,Term), Name) :-
    !,
    bare_name(Term, Name).
bare_name(named(_,Term), Name) :-
    !,
    bare_name(Term, Name).
bare_name(Term, Name) :-
    (   compound(Term)
    ->  functor(Term, Name, _)
    ;   Name = Term
    ).


                /*******************************
                *         LINE OF SIGHT        *
                *******************************/

%   walked(Scene, X, Y, Z, Walk): walk(Before, Group, In, Behind): the groups
%   before the one at the depth Z, each passed(Group, In) with the places of the
%   leaves that the line of sight is in after it; that Group; and groups behind
%   it, likewise.

walked(Scene, X, Y, Z, walk(Before,Group,In,Behind)) :-
    Group = group(Z, _),
    met(Scene, X, Y, Groups),
    passed(Groups, [], All),
    append(Before, [passed(Group,In)|Behind], All),
    !.

passed([], _, []).
passed([Group|Groups], In0, [passed(Group,In)|Passed]) :-
    Group = group(_, Mets),
    foldl(toggled, Mets, In0, In),
    passed(Groups, In, Passed).

toggled(met(Place,_,_), In0, In) :-
    ord_symdiff(In0, [Place], In).

place_because(Scene, X, Y, walk(_,group(Z,_),_,_),
              [because(seen_place(Point), [])]) :-
    model_place(Scene, X, Y, Z, Point).

model_place(Scene, X, Y, Z, Point) :-
    scene_handle(Scene, Handle),
    shading_place(Handle, X, Y, Z, Point).

%   tree_because(Scene, Leaf, Walk, Because): from the leaf up to the root.

tree_because(Scene, Leaf, walk(_,group(_,Mets),_,_), Because) :-
    met_of(Scene, Leaf, Mets, met(Place,_,Sense)),
    (   tree_way(Scene, Place, Way0)
    ->  Way = Way0
    ;   Way = []                        % a section
    ),
    maplist(step_because, Way, Steps),
    (   Sense < 0
    ->  append(Steps, [because(inner_side, [])], Because)
    ;   Because = Steps
    ).

met_of(Scene, Leaf, Mets, Met) :-
    Met = met(Place,_,_),
    member(Met, Mets),
    scene_place(Scene, place(Place,_,Leaf)),
    !.

step_because(placed(N), because(placed_as(N), [])).
step_because(operand(I,Count,Operation,N),
             because(operand_of(I,Count,Operation,N,Away), [])) :-
    (   takes_away(operand(I,Count,Operation,N))
    ->  Away = taken_away
    ;   Away = kept
    ).

%   before_because(Scene, X, Y, Walk, Because): what is passed before.

before_because(Scene, X, Y, walk(Before,group(Z,_),_,_), Because) :-
    model_place(Scene, X, Y, Z, Point),
    findall(because(Statement, Why),
            ( member(passed(group(Z1,Mets),In), Before),
              model_place(Scene, X, Y, Z1, Point1),
              apart(Point, Point1, Before1),
              passed_met(Scene, Mets, In, Before1, Statement, Why) ),
            Because).

passed_met(Scene, Mets, In, Apart, Statement, Why) :-
    append(_, [met(Place,F,Sense)|Rest], Mets),
    scene_place(Scene, place(Place,R,Leaf)),
    leaf_names(Scene, Leaf, F, What, S, Name),
    (   Sense > 0
    ->  Way = enters
    ;   Way = leaves
    ),
    Statement = passed(Way,What,Leaf,S,Name,Apart),
    (   \+ ( member(met(Other,_,_), Rest),
             scene_place(Scene, place(Other,R,_)) )
    ->  false_reason(Scene, R, In, Reason),     % said once of a root
        reason_because(Scene, R, Reason, Why)
    ;   Why = []
    ).

reason_because(_, R, true, [because(lets_through(R), [])]) :-
    !.
reason_because(_, R, cut, [because(cut_away(R), [])]) :-
    !.
reason_because(_, R, outside_all(N,Operation,Count),
               [because(outside_all(Operation,N,Count,R), [])]) :-
    !.
reason_because(_, R, taken_away(N,J,Operation),
               [because(taken_away(J,Operation,N,R), [])]) :-
    !.
reason_because(Scene, R, outside(Place),
               [because(outside_leaf(Leaf,S,Name,R), [])]) :-
    scene_place(Scene, place(Place,_,Leaf)),
    leaf_names(Scene, Leaf, 0, _, S, Name).

apart(point(X1,Y1,Z1), point(X2,Y2,Z2), Apart) :-
    Apart is sqrt((X1-X2)**2 + (Y1-Y2)**2 + (Z1-Z2)**2).

%   behind_because(Scene, X, Y, Walk, Look, Because): faces behind it at which a
%   solid begins again, or that it is see-through.

behind_because(_, _, _, _, Look, [because(see_through(A), [])]) :-
    look_opacity(Look, A),
    A < 1,
    !.
behind_because(Scene, X, Y, walk(_,group(Z,_),In,Behind), _, Because) :-
    model_place(Scene, X, Y, Z, Point),
    begun(Behind, Scene, In, Begun),
    findall(because(hidden_face(What,Leaf,S,Name,R,Apart), []),
            ( member(begun(R,Z1,Leaf,F), Begun),
              leaf_names(Scene, Leaf, F, What, S, Name),
              model_place(Scene, X, Y, Z1, Point1),
              apart(Point, Point1, Apart) ),
            Because).

begun([], _, _, []).
begun([passed(group(Z,Mets),In)|Behind], Scene, In0, Begun) :-
    findall(begun(R,Z,Leaf,F),
            ( scene_root(Scene, root(R,_)),
              false_reason(Scene, R, In, true),
              \+ false_reason(Scene, R, In0, true),
              once(( member(met(Place,F,_), Mets),
                     scene_place(Scene, place(Place,R,Leaf)) )) ),
            New),
    append(New, Begun1, Begun),
    begun(Behind, Scene, In, Begun1).


                /*******************************
                *     LOOKS, TONES, COLOURS    *
                *******************************/

look_because(R, S, Colours, Look, Because) :-
    memberchk(colour(Colour), Look),
    decided_by(surface_look/4, By),
    (   By \== default
    ->  Because = [because(look_by_rule(Colour,By), [])]
    ;   look_source(R, S, colour(_), Segment)
    ->  Because = [because(look_of(Segment,Colour), [])]
    ;   Because = [because(look_of_palette(Colour,Colours), [])]
    ).

%   side_normal(Scene, X, Y, At, Part, Walk, Normal): in the model. That of a
%   bent face is taken in the middle of the dot, where it is seen there; behind
%   others it follows from the depth near At.

side_normal(Scene, X, Y, X1-Y1, part(R,Leaf,F), Walk, Normal) :-
    scene_handle(Scene, Handle),
    XM is X+0.5,
    YM is Y+0.5,
    (   shading_point(Handle, XM, YM, span(_,_,R,Leaf,F), _, Normal0)
    ->  Normal = Normal0
    ;   shading_point(Handle, X1, Y1, span(_,_,R,Leaf,F), _, Normal0)
    ->  Normal = Normal0
    ;   Walk = walk(_,group(Z,Mets),_,_),
        member(Met, Mets),
        Met = met(Place,F,_),
        scene_place(Scene, place(Place,R,Leaf)),
        near_place(Scene, X1, Y1, Met, right, Right),
        near_place(Scene, X1, Y1, Met, down, Down)
    ->  model_place(Scene, X1, Y1, Z, Here),
        Behind is Z+1.0,
        model_place(Scene, X1, Y1, Behind, Far),
        maplist(way_from(Here), [Right,Down,Far], [A,B,C]),
        cross(A, B, N),
        unit_against(C, N, Normal)
    ;   Normal = unknown
    ).

%   near_place(Scene, X, Y, Met, Way, Point): Point of the same slice a little
%   to the right, or down; if it ends there, on the other side.

near_place(Scene, X, Y, Met, Way, Step-Point) :-
    member(Step, [0.01,-0.01]),
    (   Way == right
    ->  X1 is X+Step,
        Y1 = Y
    ;   X1 = X,
        Y1 is Y+Step
    ),
    catch(met(Scene, X1, Y1, Groups), error(domain_error(_,_),_), fail),
    member(group(Z,Mets), Groups),
    memberchk(Met, Mets),
    model_place(Scene, X1, Y1, Z, Point),
    !.

way_from(point(X0,Y0,Z0), Step-point(X1,Y1,Z1), vector(X,Y,Z)) :-
    !,
    X is (X1-X0)/Step,
    Y is (Y1-Y0)/Step,
    Z is (Z1-Z0)/Step.
way_from(Here, Point, Way) :-
    way_from(Here, 1.0-Point, Way).

cross(vector(A,B,C), vector(D,E,F), vector(X,Y,Z)) :-
    X is B*F-C*E,
    Y is C*D-A*F,
    Z is A*E-B*D.

%   unit_against(Way, Vector, Unit)

unit_against(vector(A,B,C), vector(X0,Y0,Z0), vector(X,Y,Z)) :-
    Length is sqrt(X0*X0 + Y0*Y0 + Z0*Z0),
    (   A*X0 + B*Y0 + C*Z0 > 0
    ->  Factor is -1/Length
    ;   Factor is 1/Length
    ),
    X is Factor*X0,
    Y is Factor*Y0,
    Z is Factor*Z0.

%   tone_because(Normal, Look, Because)

tone_because(unknown, _, []).
tone_because(Normal, Look, Because) :-
    Normal = vector(_, _, _),
    Because = [because(normal(Right,Up,Towards), []),
               because(tone(Tone,ToneBy), Shares),
               because(ramp(Shade,RampBy,RGB), [])|More],
    picture_normal(Normal, Seen),
    Seen = vector(Right0,Up0,Towards0),
    maplist(rounded, [Right0,Up0,Towards0], [Right,Up,Towards]),
    Look = [shade(Shade)|_],
    tone_of(Look, Seen, Tone),
    decided_by(tone/3, ToneBy),
    (   ToneBy == default
    ->  tone_sum(Shade, Constant, Ways),
        findall(because(Share, []),
                ( Constant > 0,
                  Share = light_from_everywhere(Constant)
                ; member(Way, Ways),
                  light_share(Way, Seen, Share) ),
                Shares)
    ;   Shares = []
    ),
    decided_by(ramp/3, RampBy),
    ramp_bytes(Look, Tone, RGB),
    findall(because(Statement, []), more_light(Look, Normal, Statement),
            More).

%   more_light(Look, Normal, Statement): what is added to the light of the tone.

more_light(Look, vector(X,Y,Z), shine(F,N,Added)) :-
    memberchk(shine(F,N), Look),
    look_shine(Look, shine(Power,Ways)),
    Ways = [_|_],
    findall(Light,
            ( member(way(A,B,C,Factor,_), Ways),
              Light is Factor*max(0.0, A*X+B*Y+C*Z)**Power ),
            Lights),
    sum_list(Lights, Added).
more_light(Look, _, hatched) :-
    memberchk(hatched(_), Look).

rounded(X0, X) :-
    X is round(X0*1.0e9)/1.0e9 + 0.0.

tone_of(Look, Seen, Tone) :-
    (   tone(Look, Seen, Tone0),
        number(Tone0)
    ->  Tone is max(0.0, min(1.0, Tone0))
    ;   Tone = 0.0
    ).

light_share(way(A,B,C,Factor,Least), vector(X,Y,Z),
            light_from(A,B,C,Factor,Share)) :-
    Share is max(Least, Factor*(A*X + B*Y + C*Z)).

ramp_bytes(Look, Tone, RGB) :-
    (   ramp(Look, Tone, Colour),
        shown_bytes(Colour, RGB0)
    ->  RGB = RGB0
    ;   RGB = [0,0,0]
    ).

shown_bytes(light(R,G,B), Bytes) :-
    !,
    maplist(light_byte, [R,G,B], Bytes).
shown_bytes(Colour, [R,G,B]) :-
    colour_rgb(Colour, rgb(R,G,B)).

%   light_byte(Light, Byte): the nearest.

light_byte(Light, Byte) :-
    byte_between(0, 255, Light, Low),
    High is min(255, Low+1),
    srgb_light(Low, LightLow),
    srgb_light(High, LightHigh),
    (   Light-LightLow =< LightHigh-Light
    ->  Byte = Low
    ;   Byte = High
    ).

%   The last byte whose light is not above Light.

byte_between(Low, High, Light, Byte) :-
    (   High =< Low
    ->  Byte = Low
    ;   Middle is (Low+High+1)//2,
        srgb_light(Middle, There),
        (   There =< Light
        ->  byte_between(Middle, High, Light, Byte)
        ;   Below is Middle-1,
            byte_between(Low, Below, Light, Byte)
        )
    ).


                /*******************************
                *         WHAT IS NOT SEEN     *
                *******************************/

%!  unseen_because(+S, +Options, -Because) is semidet.
%
%   Because says why nothing of segment S, a root, a node or a leaf, is seen in
%   the picture; or where it is. Fails if there is no segment S.

unseen_because(S, Options, [because(Statement, Because)]) :-
    integer(S),
    segment(S, Kind, _),
    picture_scene(Options, Scene),
    findall(Place, place_of(Scene, S, Place), Places),
    scene_opacities(Scene, Opaque),
    (   Places == []
    ->  Statement = not_in_picture(S, Kind),
        Because = []
    ;   seen_dots(Scene, Opaque, Places, Dots, X, Y),
        Dots > 0
    ->  Statement = seen_after_all(S, Dots, X, Y),
        Because = []
    ;   Statement = unseen(S),
        sampled_places(Scene, Places, Samples),
        findall(Reason-at(X1,Y1),
                ( member(sample(Place,X1,Y1), Samples),
                  unseen_at(Scene, Opaque, Place, X1, Y1, Reason) ),
                Reasons),
        unseen_reasons(Reasons, Because)
    ).

%   place_of(Scene, S, Place): a leaf of the kernel that is one of S.

place_of(Scene, S, Place) :-
    scene_place(Scene, place(Place,R,Leaf)),
    (   R =:= S
    ->  true
    ;   once(scene_leaf(Scene, leaf(Leaf,_,S,_,_)))
    ->  true
    ;   tree_way(Scene, Place, Way),
        member(Step, Way),
        ( Step = placed(S) ; Step = operand(_,_,_,S) )
    ->  true
    ).

%   seen_dots(Scene, Opaque, Places, Dots, X, Y): about how many dots show them,
%   and one of these.

seen_dots(Scene, Opaque, Places, Dots, X, Y) :-
    scene_handle(Scene, Handle),
    findall(Leaf,
            ( member(Place, Places), scene_place(Scene, place(Place,_,Leaf)) ),
            Leaves0),
    sort(Leaves0, Leaves),
    scene_size(Scene, _-Height),
    Last is Height-1,
    findall(Wide-at(X1,Row),
            ( between(0, Last, Row),
              Middle is Row+0.5,
              shading_layers(Handle, Middle, Opaque, Layers),
              member(layer(A,B,_,Leaf,_,_), Layers),
              memberchk(Leaf, Leaves),
              Wide is B-A,
              X1 is (A+B)//512 ),
            Wides),
    (   sort(1, @>=, Wides, [_-at(X,Y)|_])
    ->  findall(W, member(W-_, Wides), Ws),
        sum_list(Ws, Sum),
        Dots is max(1, round(Sum/256))
    ;   Dots = 0
    ).

%   sampled_places(Scene, Places, Samples): in the middle of their slices, on 64
%   lines at most.

sampled_places(Scene, Places, Samples) :-
    scene_size(Scene, Width-Height),
    member(Step0, [64,4096]),
    Step is max(1, Height//Step0),
    Last is (Height-1)//Step,
    findall(sample(Place,X,Y),
            ( between(0, Last, I),
              Y is I*Step + 0.5,
              place_slice(Scene, Places, Y, Place, X1, X2),
              Left is max(0.0, X1),
              Right is min(float(Width), X2),
              Left < Right,
              X is (Left+Right)/2 ),
            Samples0),
    Samples0 = [_|_],
    !,
    Samples = Samples0.
sampled_places(_, _, []).

place_slice(Scene, Places, Y, Place, X1, X2) :-
    slice(Scene, Y, slice(_,Leaf,_,Sense,X1,X2,_)),
    Sense =\= 0,
    scene_place(Scene, place(Place,_,Leaf)),
    memberchk(Place, Places).

%   unseen_at(Scene, Opaque, Place, X, Y, Reason): of each of its faces there.

unseen_at(Scene, Opaque, Place, X, Y, Reason) :-
    met(Scene, X, Y, Groups),
    passed(Groups, [], All),
    append(Before, [passed(group(Z,Mets),In)|_], All),
    memberchk(met(Place,_,_), Mets),
    scene_place(Scene, place(Place,R,_)),
    (   append(_, [passed(_,In0)], Before)
    ->  true
    ;   In0 = []
    ),
    false_reason(Scene, R, In, Now),
    false_reason(Scene, R, In0, Was),
    (   Now == true,
        Was == true
    ->  Reason = buried(R)
    ;   Now == true
    ->  seen_before(Scene, Opaque, X, Y, Z, Reason)
    ;   Was \== true
    ->  reason_because(Scene, R, Now, [because(Why, _)]),
        Reason = not_there(Why)
    ;   Reason = back(R)
    ).

seen_before(Scene, Opaque, X, Y, Z, hidden(R,Leaf,S,Name)) :-
    seen_layers(Scene, X, Y, Layers),
    member(layer(Z1,R,Leaf,F), Layers),
    Z1 < Z,
    face_opacity(Opaque, Leaf, F, A),
    A >= 1,
    !,
    leaf_names(Scene, Leaf, 0, _, S, Name).
seen_before(_, _, _, _, _, thin).

%   unseen_reasons(Reasons, Because): each with how often it was met and where,
%   the most frequent first; backs only if there is nothing else.

unseen_reasons([], [because(out_of_the_picture, [])]) :-
    !.
unseen_reasons(Reasons0, Because) :-
    (   member(Reason-_, Reasons0),
        Reason \= back(_)
    ->  findall(Reason1-At,
                ( member(Reason1-At, Reasons0), Reason1 \= back(_) ), Reasons1)
    ;   Reasons1 = Reasons0
    ),
    keysort(Reasons1, Reasons),
    group_pairs_by_key(Reasons, Groups),
    findall(Count-because(unseen_where(Count,X,Y), [because(Why, [])]),
            ( member(Reason2-Ats, Groups),
              length(Ats, Count),
              Ats = [at(X0,Y0)|_],
              X is floor(X0),
              Y is floor(Y0),
              unseen_why(Reason2, Why) ),
            Counted0),
    sort(1, @>=, Counted0, Counted),
    pairs_values(Counted, Because).

unseen_why(hidden(R,Leaf,S,Name), hidden_by_leaf(Leaf,S,Name,R)).
unseen_why(buried(R), buried_in(R)).
unseen_why(back(R), back_side(R)).
unseen_why(thin, thinner_than_a_dot).
unseen_why(not_there(Why), Why).
