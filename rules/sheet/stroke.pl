:- module(sg_stroke,
          [ strokes/2,                  % +Parts, -Strokes
            picture_looks/1,            % -Looks
            stroke_key/4,               % +Strokes, -Visibility, -Role, -S
            single_strokes/2,           % +Strokes, -Singles
            all_strokes/2,              % +Strokess, -Singles
            stroke_length/2             % +Stroke, -Length
          ]).
:- use_module('../kernel',
              [chain_strokes/4, stroke_chains/3, stroke_looks/2]).
:- use_module('../picture/role', [role_rank/2]).
:- use_module(library(apply), [foldl/4, maplist/3]).
:- use_module(library(lists), [append/2, member/2, nth1/3]).
/** <module> Strokes: drawn parts put end to end.

A pen should not lift where a line goes on, and dashes should run on across
the joints of a line: a curve of short pieces, each dashed alone, looks solid.
So parts of one visibility, role and segment that meet are chained.

    part(Visibility, Role, S, E, From, To, A, B)
        a part of edge E of segment S, from A to B on the sheet; A and B are
        X-Y, integers; From and To say where on the edge, 0 to 1.
    stroke(Visibility, Role, S, Edges, Points, Start, End)
        a chain; the k-th of Edges goes from the k-th of Points to the next.
        Start and End: `cut`, where the line goes on visible instead of hidden
        or the other way; `ring`, both, if it closes; else `joint`.
    strokes(Visibility, Role, S, Chains, From, To)
        many, one after the other: those From to To of Chains, which C holds.

A picture may have millions, so the strokes of drawn/7 are of the last kind, a
thousand at most in each: who goes through them has that many as terms at a
time.

At each point the parts are joined in pairs, the straightest pair first. The
pen follows a visible line round any corner; a hidden line ends at a corner,
so that its dashes can meet there. A line goes on as the same edge; or, where no
other line of its visibility ends, as one that goes straight on: one of the same
segment and role may bend as much as a hidden line, any other may not.
*/

:- set_prolog_flag(optimise, true).

%!  strokes(+Parts, -Strokes) is det.
%
%   Strokes are the chains of Parts, in painting order: hidden before visible,
%   penetration lines last, then by segment. Each part is in one
%   stroke, except that parts without length are left out, and that of parts
%   with the same two ends only the last in painting order is drawn: a visible
%   line hides the dashes under it.

strokes(Parts, Strokes) :-
    stroke_looks(Parts, Looks0),
    msort(Looks0, Looks1),
    maplist(ranked_look, Looks1, Looks),
    stroke_chains(Parts, Looks, Strokes).

%!  picture_looks(-Looks) is det.
%
%   Looks, for stroke_chains/3, are all that drawn/7 may have.

picture_looks(Looks) :-
    findall(Visibility-Role,
            ( member(Visibility, [hidden,visible]), role_rank(Role, _) ),
            Looks0),
    msort(Looks0, Looks1),
    maplist(ranked_look, Looks1, Looks).

ranked_look(Visibility-Role, look(Visibility,Role,Rank)) :-
    paint_rank(Visibility, Role, Rank).

paint_rank(Visibility, Role, Rank) :-
    (   Visibility == hidden
    ->  Below = 0
    ;   Below = 100
    ),
    (   nth1(Place, [mesh,smooth,section,crease,border,outline,curve], Role)
    ->  true
    ;   Role == penetration
    ->  Place = 9
    ;   Place = 8
    ),
    !,
    Rank is Below+Place.

%!  stroke_key(+Strokes, -Visibility, -Role, -S) is det.
%
%   What Strokes, one or many, have in common.

stroke_key(stroke(Visibility,Role,S,_,_,_,_), Visibility, Role, S).
stroke_key(strokes(Visibility,Role,S,_,_,_), Visibility, Role, S).

%!  single_strokes(+Strokes, -Singles) is det.
%
%   Singles are Strokes, one or many, one by one.

single_strokes(strokes(_,_,_,Chains,From,To), Singles) =>
    chain_strokes(Chains, From, To, Singles).
single_strokes(Stroke, Singles) =>
    Singles = [Stroke].

%!  all_strokes(+Strokess, -Singles) is det.
%
%   Singles are all of the list Strokess, one by one, in order.

all_strokes(Strokess, Singles) :-
    maplist(single_strokes, Strokess, Lists),
    append(Lists, Singles).

%!  stroke_length(+Stroke, -Length) is det.
%
%   Length of Stroke on the sheet, in the unit of its points.

stroke_length(stroke(_,_,_,_,[Point|Points],_,_), Length) :-
    foldl(longer, Points, Point-0.0, _-Length).

longer(X-Y, (X0-Y0)-L0, (X-Y)-L) :-
    L is L0 + sqrt((X-X0)**2 + (Y-Y0)**2).
