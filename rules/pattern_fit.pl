:- module(sg_pattern_fit,
          [ fitted_pieces/5             % +Pieces, +Paper, +Options, -Fitted,
                                        % -Tabs
          ]).
:- use_module(pattern_lines, [outline_loops/2, piece_outline/3]).
:- use_module(pattern_nest, [fits_on/2]).
:- use_module(pattern_slit, [opened_slits/3]).
:- use_module(pattern_split, [split_piece/3]).
:- use_module(pattern_tab, [deepest_tab/3, tabs/4]).
:- use_module(library(apply), [foldl/5, maplist/3]).
:- use_module(library(assoc), 
              [gen_assoc/3, get_assoc/3, list_to_assoc/2, put_assoc/4]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists), 
              [ append/2, append/3, member/2, nth1/3, same_length/2,
                subtract/3
              ]).
:- use_module(library(option), [option/3]).
:- use_module(library(pairs), 
              [group_pairs_by_key/2, pairs_keys_values/3]).
/** <module> Pieces with their tabs, none larger than the paper.

Whether a piece with its tabs fits on the paper is known only when it has them;
then its neighbours may have been divided, and tabs changed sides. So pieces are
divided that do not fit without tabs, then those that do not with them, until
all do.
*/

:- set_prolog_flag(optimise, true).

%!  fitted_pieces(+Pieces, +Paper, +Options, -Fitted, -Tabs) is det.
%
%   Fitted are fitted(Piece,Outline), Pieces (pattern_piece.pl) or parts of
%   them, name(D,K,Part) with Part from 1, each with its outline round its tabs
%   (pattern_lines.pl). Tabs is tabs(Tabs,Butt): assocs, of tab(D,E,A,B) to what
%   tabs/4 says, and of the seams D-J that have none to an edge of theirs.
%   Options are tabs(Width) and open_slits(Bool). What was divided is told.
%
%   @error usage_error(pattern(tabs(Width, Most, W-H))): where pieces have to be
%          divided, a page with room for W x H mm takes tabs of at most Most

fitted_pieces(Pieces0, Paper, Options, Fitted, Tabs) :-
    option(tabs(Width), Options, 0),
    must_be(number, Width),
    option(open_slits(Open), Options, false),
    pieces_opened(Open, Width, Pieces0, Pieces1),
    told_more(opened, Pieces0, Pieces1),
    pieces_fitted(Pieces1, Paper, Width, [], Fitted, Tabs),
    told_more(divided, Pieces1, Fitted),
    Tabs = tabs(_, Butt),
    told_butt(Butt).

told_more(What, Before, After) :-
    length(Before, N0),
    length(After, N),
    (   N > N0
    ->  Told =.. [What,N0,N],
        print_message(warning, sanggwan(pattern(Told)))
    ;   true
    ).

%   Seams without tabs are told by their edges, pattern by pattern.

told_butt(Butt) :-
    findall(D-E, gen_assoc(D-_, Butt, E), Pairs),
    group_pairs_by_key(Pairs, Groups),
    forall(member(D-Es0, Groups),
           ( length(Es0, N),
             sort(Es0, Es1),
             subtract(Es1, [0], Es),
             print_message(informational,
                           sanggwan(pattern(without_tab(D, N, Es)))) )).

%   pieces_opened(Open, Width, Pieces0, Pieces): until no slit is left that
%   opens; parting a piece moves tabs, which may close others.

pieces_opened(Open, Width, Pieces0, Pieces) :-
    (   Open == true,
        Width > 0
    ->  rounds(Most),
        slits_opened(Most, Width, Pieces0, Pieces)
    ;   Pieces = Pieces0
    ).

rounds(6).

slits_opened(0, _, Pieces, Pieces) :-
    !.
slits_opened(N, Width, Pieces0, Pieces) :-
    pieces_tabs(Width, Pieces0, tabs(_,Butt)),
    opened_slits(Pieces0, Butt, Pieces1),
    (   same_length(Pieces0, Pieces1)
    ->  Pieces = Pieces0
    ;   numbered_parts(Pieces1, Pieces2),
        N1 is N-1,
        slits_opened(N1, Width, Pieces2, Pieces)
    ).

pieces_tabs(Width, Pieces, tabs(Tabs,Butt)) :-
    (   Width > 0
    ->  tabs(Width, Pieces, Pairs, Left)
    ;   Pairs = [],
        Left = []
    ),
    list_to_assoc(Pairs, Tabs),
    list_to_assoc(Left, Butt).

%   numbered_parts(Parts, Numbered): parts of one piece are name(D,K,1),
%   name(D,K,2), ... in their order; a whole piece is name(D,K,0).

numbered_parts(Parts, Numbered) :-
    findall((D-K)-x, member(piece(name(D,K,_),_,_), Parts), Keyed0),
    keysort(Keyed0, Keyed),
    group_pairs_by_key(Keyed, Groups),
    findall(Key-next(First),
            ( member(Key-Xs, Groups),
              ( Xs = [_] -> First = 0 ; First = 1 )
            ),
            Counts0),
    list_to_assoc(Counts0, Counts),
    foldl(numbered_part, Parts, Numbered, Counts, _).

numbered_part(piece(name(D,K,_),Faces,Sides), piece(name(D,K,I),Faces,Sides),
              Counts0, Counts) :-
    get_assoc(D-K, Counts0, next(I)),
    I1 is I+1,
    put_assoc(D-K, Counts0, next(I1), Counts).


                /*******************************
                *            PAPER             *
                *******************************/

%   pieces_fitted(Pieces0, Paper, Width, Tight, Fitted, Tabs): those of Pieces0
%   whose places are in Tight are divided so that there is room for tabs all
%   round their parts.

pieces_fitted(Pieces0, Paper, Width, Tight, Fitted, Tabs) :-
    pieces_split(Pieces0, Paper, Width, Tight, Split, Origins),
    numbered_parts(Split, Pieces),
    pieces_tabs(Width, Pieces, Tabs0),
    Tabs0 = tabs(Outward, _),
    maplist(fitted_piece(Outward), Pieces, Fitted0),
    findall(I,
            ( nth1(N, Fitted0, fitted(_,Outline)),
              nth1(N, Origins, I),
              \+ memberchk(I, Tight),
              \+ outline_fits(Outline, Paper)
            ),
            More),
    (   More == []
    ->  Fitted = Fitted0,
        Tabs = Tabs0
    ;   append(More, Tight, Tight1),
        sort(Tight1, Tight2),
        pieces_fitted(Pieces0, Paper, Width, Tight2, Fitted, Tabs)
    ).

fitted_piece(Tabs, Piece, fitted(Piece,Outline)) :-
    piece_outline(Piece, Tabs, Outline).

outline_fits(Outline, Paper) :-
    outline_loops(Outline, Loops),
    append(Loops, Points),
    (   Points == []
    ->  true
    ;   fits_on(Points, Paper)
    ).

%   Origins are the places in Pieces0 of the pieces that Split are parts of.

pieces_split(Pieces0, Paper, Width, Tight, Split, Origins) :-
    (   Tight == []
    ->  Narrow = Paper
    ;   tab_room(Paper, Width, Pieces0, Narrow)
    ),
    findall(I-Part,
            ( nth1(I, Pieces0, Piece),
              (   memberchk(I, Tight)
              ->  split_piece(Piece, Narrow, Parts)
              ;   split_piece(Piece, Paper, Parts)
              ),
              member(Part, Parts)
            ),
            Pairs),
    pairs_keys_values(Pairs, Origins, Split).

%   tab_room(Paper, Width, Pieces, Narrow): what is left of Paper if a piece
%   grows by a tab on each side, as deep as the longest seam may have one.

tab_room(room(W0,H0,Gap), Width, Pieces, room(W,H,Gap)) :-
    deepest_tab(Width, Pieces, Deep),
    Most is min(W0, H0)/4,
    (   Deep =< Most
    ->  W is W0-2*Deep,
        H is H0-2*Deep
    ;   Whole is floor(Most),
        throw(error(usage_error(pattern(tabs(Width, Whole, W0-H0))), _))
    ).
