:- module(sg_hidden_lines,
          [ least_drawn/1,              % -Least
            picture/0,
            picture/1,                  % +Options
            open_scene/2,               % -Scene, +Options
            open_scene/3,               % +Lines, -Scene, +Options
            may_hide/2,                 % +S2, +S
            may_hide/4,                 % +S2, +T, +S, +E
            lies_on/4,                  % ?S, ?E, ?S2, -P
            line_facing/7,              % +S, +E, -S2, -T, -From, -To, -Ts
            hidden_interval/5,          % +Scene, +S, +E, -From, -To
            hidden_interval/6,          % +Scene, +S, +E, -S2, -From, -To
            line_parts/5,               % +Scene, +S, +E, -Visible, -Hidden
            hidden_by/6,                % ?S, ?E, -S2, -T, -From, -To
            hidden_by_polygon/6,        % ?S, ?E, -S2, -P, -From, -To
            substitute_outline/2                 % +S, +E
          ]).
:- use_module('../near', [tolerance/2]).
:- use_module(library(assoc), [list_to_assoc/2, get_assoc/3]).
:- use_module(library(lists), [member/2, memberchk/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
:- use_module(library(error), [must_be/2, domain_error/2]).
:- use_module(contour, [faceted_segments/1, find_contours/2, smoothness/2]).
:- use_module('../decision', [decision/2, decision_is_default/1]).
:- use_module('../csg/known_surface', [known_surfaces/1]).
:- use_module('../interval',
              [ intervals_union/3, intervals_gaps/2, intervals_subtract/3,
                intervals_within/4
              ]).
:- use_module(line_segment, [lines_given/1]).
:- use_module(role,
              [ backs_seen/2, edge_role/5, role_rank/2, role_drawn/2,
                usual_crease/1
              ]).
:- use_module(view, [project_world/0, screen_depth/1]).
:- use_module('../polygon/triangulation', [new_segments_complete/0]).
:- use_module('../stage', [stage/2]).
:- use_module('../store',
              [ segment/3, e/5, t/6, line/9, edge_polygon/3, contour/13,
                surface_facing/6,
                assert_fact/1, retractall_facts/1, facts_transaction/1
              ]).
:- use_module('../kernel',
              [ scene_close/1, scene_open/7, scene_edge/5, scene_near/2,
                occluder/7, overlap/9, fill_drawn/4
              ]).
/** <module> Hidden lines: the picture of a world.

picture/1 fills screen/5 and drawn/7. Hidden parts are kept, so that they can be
dashed; nothing is drawn twice: where lines lie on one another in the picture a
visible one is drawn, not a hidden one, and the role and the order of the edges
decide between two of a kind (a box seen squarely has no hidden line at all).

What is seen of a smooth surface ends where its triangles turn from the eye. If
no other line is there, such a side is drawn as a substitute outline
(contour.pl). It comes last. It yields to a line that is nearer than 1/400 of
the picture if it runs along that line more than across. It is drawn only where
it is seen and nothing is near behind it, since otherwise the surface goes on
there. So there is one line, and only one, wherever what is seen ends.

Near the outline of a known surface hides what the surface is, not its triangles
(contour.pl): so what passes behind it ends at the outline that is drawn.

The rules here define what is drawn. The join occluder/7 finds the triangles
that hide a part of a line; triangles that are seen edge-on and the backs of
solids are not among them (PL-13 steps 1 and 2). As long as nobody replaces a
decision, the kernel fill_drawn/4 computes the same for the whole world.

@see [PL] section 6.3: PL-13.
*/

%!  picture is det.
%!  picture(+Options) is det.
%
%   Make the picture of the current world: fill screen/5 and drawn/7, replacing
%   what they held. One operation. Options:
%
%     - lines(Which): `feature` (default), `all` or `penetration`, see
%       role_drawn/2
%     - segments(List): draw these only; the others do not hide either
%     - crease(Degrees): over which bend an edge is a crease; default 30
%     - tolerance(T): what counts as equal, in a model of size [-1,1]; default
%       1.0e-9
%     - method(M): `kernel`, `rule`, or `auto` (default): the kernel, unless a
%       decision is replaced
%
%   @error geometry_error(eye_in_model(D))
%   @error domain_error(lines, Which), domain_error(method, M)

picture :-
    picture([]).

picture(Options) :-
    option(lines(Which), Options, feature),
    one_of(lines, [all,feature,penetration], Which),
    usual_crease(Usual),
    option(crease(Crease), Options, Usual),
    must_be(number, Crease),
    option(method(Method0), Options, auto),
    one_of(method, [auto,kernel,rule], Method0),
    picture_method(Method0, Method),
    facts_transaction(
        (   new_segments_complete,
            project_world,
            option(segments(Segments), Options, all),
            outlines(Which, Segments, Crease),
            scene_lines(Method, Which, Crease, Lines),
            open_scene(Lines, Scene, Options),
            call_cleanup(draw(Method, Scene, Which, Crease),
                         scene_close(Scene)),
            lines_given(Segments)
        )).

%   The kernel stands in for the rules as long as they are the default ones.
picture_method(kernel, kernel).
picture_method(rule, rule).
picture_method(auto, Method) :-
    (   decision_is_default(edge_role/5),
        decision_is_default(may_hide/4)
    ->  Method = kernel
    ;   Method = replaced
    ).

%   The kernel asks for the lines that it draws, the rules for others too.
scene_lines(Method, Which, Crease, Lines) :-
    (   Method == kernel
    ->  Lines = drawn(Which, Crease)
    ;   Lines = every
    ).

%   A picture of all edges shows the triangles as they are, so it has no
%   outlines inside them; one of penetration lines alone needs none.
outlines(Which, Segments, Crease) :-
    (   Which == feature
    ->  find_contours(Segments, Crease)
    ;   retractall_facts(contour(_,_,_,_,_,_,_,_,_,_,_,_,_)),
        retractall_facts(surface_facing(_,_,_,_,_,_))
    ).

one_of(Domain, Values, Value) :-
    must_be(atom, Value),
    (   memberchk(Value, Values)
    ->  true
    ;   domain_error(Domain, Value)
    ).

draw(kernel, Scene, Which, Crease) :-
    seen_through(Through),
    stage(join, fill_drawn(Scene, Which, Crease, Through)).
draw(rule, Scene, Which, Crease) :-
    stage(rules, draw_by_rule(Scene, Which, Crease, _)).
draw(replaced, Scene, Which, Crease) :-
    get_time(T0),
    stage(rules, draw_by_rule(Scene, Which, Crease, Lines)),
    get_time(T),
    Each is (T-T0)*1.0e6/max(1, Lines),
    print_message(informational, sanggwan(lines_by_rules(Lines, Each))).

%   seen_through(Pairs): the S-S2 where segment S2 hides no line of S.

seen_through(Pairs) :-
    (   decision_is_default(may_hide/2)
    ->  Pairs = []
    ;   findall(S-S2,
                ( segment(S, _, _), segment(S2, _, _), \+ may_hide(S2, S) ),
                Pairs)
    ).

%!  open_scene(-Scene, +Options) is det.
%!  open_scene(+Lines, -Scene, +Options) is det.
%
%   True when Scene is what the current world's screen/5, contour/13 and
%   surface_facing/6 show: the lines and triangles for the joins scene_edge/5,
%   occluder/7 and overlap/9. It does not follow later changes. Options
%   segments(List), lines(Which), crease(Degrees) and tolerance(T) as for
%   picture/1. Lines is `every` or drawn(Which, Crease), see scene_open/7.

open_scene(Scene, Options) :-
    open_scene(every, Scene, Options).

open_scene(Lines, Scene, Options) :-
    option(segments(Segments), Options, all),
    tolerance(rounding, Rounding),
    option(tolerance(Tolerance), Options, Rounding),
    option(lines(Which), Options, feature),
    (   Which == feature
    ->  usual_crease(Usual),
        option(crease(Crease), Options, Usual),
        smoothness(Crease, Smooth)
    ;   faceted_segments(Faceted),
        Smooth = edges(Faceted)
    ),
    screen_depth(Depth),
    stage(tree,
          (   scene_open(Segments, Depth, Tolerance, Smooth, Lines, kept,
                         Scene)
          ->  true
          ;   known_surfaces(Known),
              scene_open(Segments, Depth, Tolerance, Smooth, Lines, Known,
                         Scene)
          )).

:- decision(may_hide/4, "Which triangles may hide which lines (PL-13)").

%!  may_hide(+S2, +T, +S, +E) is semidet.
%
%   True when triangle T of segment S2 may hide edge E of segment S. It may if
%   may_hide/2 lets it. A decision; asked for every triangle that lies before a
%   line.

may_hide(S2, _, S, _) :-
    may_hide(S2, S).

:- decision(may_hide/2, "Which segments may hide whose lines (PL-13)").

%!  may_hide(+S2, +S) is semidet.
%
%   True when segment S2 may hide lines of segment S. It always may. A decision,
%   asked once for each two segments, and for each with itself: one that does
%   not hide its own lines shows its back too. A world can make a segment of
%   glass. A shaded picture asks it once for each two roots.

may_hide(_, _).

%!  lies_on(?S, ?E, ?S2, -P) is nondet.
%
%   True when edge E of segment S lies on polygon P of S2 because the model says
%   so: P has it, or an edge with the same ends, or a copy of such a one, by a
%   penetration line. A flat polygon never hides what lies on it; of one that is
%   not flat, the triangles that have the edge do not. The join occluder/7 keeps
%   to this, whatever rounding makes of the places. May come more than once.

lies_on(S, E, S2, P) :-
    edge_ends(S, E, V1, V2),
    same_ends(S, V1, V2, S2, W1, W2),
    edge_ends(S2, E2, W1, W2),
    edge_polygon(S2, E2, P).

edge_ends(S, E, V1, V2) :-
    e(S, E, V1, V2, _).
edge_ends(S, E, V1, V2) :-
    e(S, E, V2, V1, _).

same_ends(S, V1, V2, S, V1, V2).
same_ends(S, V1, V2, S2, W1, W2) :-
    line(_, S, _, V1, V2, S2, _, W1, W2).
same_ends(S, V1, V2, S2, W1, W2) :-
    line(_, S2, _, W1, W2, S, _, V1, V2).

%!  line_facing(+S, +E, -S2, -T, -From, -To, -Ts) is nondet.
%
%   True when a smooth surface of segment S2 turns edge E of segment S otherwise
%   than its triangle T is turned: surface_facing/6. It hides the part from From
%   to To (0.0 at the start of E in the picture, 1.0 at its end; equal: none),
%   and the triangles Ts of S2 do not hide E: the join occluder/7 keeps to that.

line_facing(S, E, S2, T, From, To, Ts) :-
    e(S, E, V1, V2, _),
    copied_ends(S, V1, V2, S2, W1, W2),
    surface_facing(S2, T, I, Low, High, Ts),
    t(S2, _, T, A, B, C),
    side_ends(I, A, B, C, U1, U2),
    once(( W1-W2 == U1-U2 ; W1-W2 == U2-U1 )),
    (   W1 < W2
    ->  From = Low,
        To = High
    ;   From is 1.0-High,
        To is 1.0-Low
    ).

%   With the ends in the order of the edge, whichever way the line runs.

copied_ends(S, V1, V2, S2, W1, W2) :-
    same_ends(S, V1, V2, S2, W1, W2).
copied_ends(S, V1, V2, S2, W1, W2) :-
    same_ends(S, V2, V1, S2, W2, W1),
    S2-W1-W2 \== S-V1-V2.

side_ends(1, A, B, _, A, B).
side_ends(2, _, B, C, B, C).
side_ends(3, A, _, C, C, A).

%!  hidden_interval(+Scene, +S, +E, -From, -To) is nondet.
%!  hidden_interval(+Scene, +S, +E, -S2, -From, -To) is nondet.
%
%   True when segment S2 hides the part of edge E from From to To: all of it, if
%   its faces are backs of a solid (step 2), or the part that a triangle hides
%   (step 4); or the part that a smooth surface hides that it lies on: of an
%   outline in triangles what lies behind the fold, of others what is turned
%   away.

hidden_interval(Scene, S, E, From, To) :-
    hidden_interval(Scene, S, E, _, From, To).

hidden_interval(Scene, S, E, S, 0.0, 1.0) :-
    scene_edge(Scene, S, E, _, Look),
    backs_seen(Look, _),
    may_hide(S, S).
hidden_interval(_, S, E, S, 0.0, 1.0) :-
    E < 0,
    K is -E,
    contour(S, K, _, _, _, _, _, hidden, _, _, _, _, _),
    may_hide(S, S).
hidden_interval(_, S, E, S2, From, To) :-
    E > 0,
    line_facing(S, E, S2, _, From, To, _),
    From < To,
    may_hide(S2, S).
hidden_interval(Scene, S, E, S2, From, To) :-
    occluder(Scene, S, E, S2, T, From, To),
    may_hide(S2, T, S, E).

%!  line_parts(+Scene, +S, +E, -Visible, -Hidden) is det.
%
%   True when Visible and Hidden are the intervals of edge E that are seen and
%   that are not, whatever other lines lie there. Parts too short to be drawn
%   are left out.

line_parts(Scene, S, E, Visible, Hidden) :-
    shortest(Scene, S, E, Least),
    findall(From-To, hidden_interval(Scene, S, E, From, To), Intervals0),
    sort(0, @=<, Intervals0, Intervals),
    intervals_union(Least, Intervals, Hidden),
    intervals_gaps(Hidden, Visible).

%!  least_drawn(-Least) is det.
%
%   What is shorter than Least is not drawn, in a model of size [-1,1].

least_drawn(1.0e-7).

%   The smallest interval of an edge that is drawn.
shortest(Scene, S, E, Least) :-
    scene_edge(Scene, S, E, Length, _),
    least_drawn(Least0),
    Least is Least0/Length.

%   A substitute outline that other lines interrupt is drawn only in gaps longer
%   than scene_near/2. One that is shorter as a whole is always drawn.
shortest_drawn(Scene, S, E, Least) :-
    (   substitute_outline(S, E)
    ->  scene_edge(Scene, S, E, Length, _),
        scene_near(Scene, Near),
        Least is min(Near/Length, 0.999)
    ;   shortest(Scene, S, E, Least)
    ).

%!  substitute_outline(+S, +E) is semidet.
%
%   True when line E of drawn/7 is a substitute outline: a side of a smooth
%   surface at which triangles turn from the eye (contour.pl).

substitute_outline(S, E) :-
    E < 0,
    K is -E,
    contour(S, K, _, _, _, _, _, substitute, _, _, _, _, _).

%!  hidden_by_polygon(?S, ?E, -S2, -P, -From, -To) is nondet.
%
%   True when polygon P of segment S2 hides the part of edge E from From to To,
%   in the picture that screen/5 holds: the parts that its triangles hide, put
%   together.

hidden_by_polygon(S, E, S2, P, From, To) :-
    open_scene(Scene, []),
    findall(p(S,E,S2,P)-(From0-To0),
            ( scene_edge(Scene, S, E, _, _),
              occluder(Scene, S, E, S2, T, From0, To0),
              may_hide(S2, T, S, E),
              t(S2, P, T, _, _, _)
            ),
            Parts0),
    keysort(Parts0, Parts),
    group_pairs_by_key(Parts, Groups),
    member(p(S,E,S2,P)-Intervals0, Groups),
    sort(Intervals0, Intervals),
    shortest(Scene, S, E, Least),
    intervals_union(Least, Intervals, Union),
    member(From-To, Union).

%!  hidden_by(?S, ?E, -S2, -T, -From, -To) is nondet.
%
%   True when triangle T of segment S2 hides the part of edge E from From to To,
%   in the picture that screen/5 holds.

hidden_by(S, E, S2, T, From, To) :-
    open_scene(Scene, []),
    scene_edge(Scene, S, E, _, _),
    occluder(Scene, S, E, S2, T, From, To),
    may_hide(S2, T, S, E).

                /*******************************
                *        BY THE RULES          *
                *******************************/

draw_by_rule(Scene, Which, Crease, Count) :-
    findall((S-E)-Role, drawn_line(Scene, Which, Crease, S, E, Role), Lines0),
    length(Lines0, Count),
    maplist(with_parts(Scene), Lines0, Lines),
    list_to_assoc(Lines, Drawing),
    retractall_facts(drawn(_,_,_,_,_,_,_)),
    foldl(draw_line(Scene, Drawing), Lines, 1, _).

%   The lines that are drawn, unless something else is drawn there.
drawn_line(Scene, Which, Crease, S, E, Role) :-
    scene_edge(Scene, S, E, Length, Look),
    least_drawn(Least),
    Length > Least,
    edge_role(S, E, Look, Crease, Role),
    once(role_drawn(Which, Role)).

with_parts(Scene, (S-E)-Role, (S-E)-line(Rank-Role,Visible,Hidden)) :-
    line_parts(Scene, S, E, Visible, Hidden0),
    (   substitute_outline(S, E)
    ->  Rank = last,
        Hidden = []
    ;   role_rank(Role, Rank),
        Hidden = Hidden0
    ).

draw_line(Scene, Drawing, (S-E)-line(Rank-Role,Visible0,Hidden0), D0, D) :-
    findall(over(Line2,Map), overlapped(Scene, Drawing, S, E, Line2, Map),
            Others),
    foldl(yield(Rank-(S-E), visible), Others, Visible0, Visible),
    foldl(yield(Rank-(S-E), hidden), Others, Hidden0, Hidden),
    shortest_drawn(Scene, S, E, Least),
    findall(From-part(To,Visibility),
            (   member(Visibility-Set, [visible-Visible, hidden-Hidden]),
                member(From-To, Set),
                To-From > Least
            ),
            Parts0),
    keysort(Parts0, Parts),
    foldl(assert_part(S, E, Role), Parts, D0, D).

assert_part(S, E, Role, From-part(To,Visibility), D0, D) :-
    assert_fact(drawn(D0, S, E, From, To, Visibility, Role)),
    D is D0+1.

%   Line2 is drawn too and lies on edge E from From to To, which is From2 to
%   To2 of it.
overlapped(Scene, Drawing, S, E, (S2-E2)-Line2, map(From,To,From2,To2)) :-
    overlap(Scene, S, E, S2, E2, From, To, From2, To2),
    get_assoc(S2-E2, Drawing, Line2).

%   Visible parts give way to visible ones of a line that comes before; hidden
%   ones to every visible one, and to hidden ones of a line that comes before.
yield(Order, Visibility, over(Id2-line(Rank2-_,Visible,Hidden),Map),
      Set0, Set) :-
    (   Rank2-Id2 @< Order
    ->  Before = true
    ;   Before = false
    ),
    (   ( Visibility == hidden ; Before == true )
    ->  subtract_mapped(Visible, Map, Set0, Set1)
    ;   Set1 = Set0
    ),
    (   Visibility == hidden,
        Before == true
    ->  subtract_mapped(Hidden, Map, Set1, Set)
    ;   Set = Set1
    ).

subtract_mapped(Theirs, map(From,To,From2,To2), Set0, Set) :-
    Low is min(From2, To2),
    High is max(From2, To2),
    Rate is (To-From)/(To2-From2),
    intervals_within(Theirs, Low, High, Within),
    foldl(subtract_part(From, From2, Rate), Within, Set0, Set).

subtract_part(From, From2, Rate, X-Y, Set0, Set) :-
    A is From + (X-From2)*Rate,
    B is From + (Y-From2)*Rate,
    Low is min(A, B),
    High is max(A, B),
    intervals_subtract(Set0, Low-High, Set).
