:- module(sg_pattern_fit,
          [ fitted_pieces/5,            % +Pieces, +Paper, +Options, -Fitted,
                                        % -Tabs
            joint_depth/3,              % +Options, -Joint, -Deep
            joint_is_wide/5             % +Joint, +Most, +Deep, +W, +H
          ]).
:- use_module(pattern_allowance, [allowances/5, strip_depth/3]).
:- use_module(pattern_lines, [outline_loops/2, piece_outline/3]).
:- use_module(pattern_nest, [fits_on/2]).
:- use_module(pattern_slit, [opened_slits/5]).
:- use_module(pattern_split, [split_piece/4]).
:- use_module(pattern_strip, [seam_runs/3]).
:- use_module(pattern_tab,
              [ butt_reasons/4, deepest_tab/3, side_length/2, tab_shape/4,
                tabs/5
              ]).
:- use_module(library(apply),
              [foldl/4, foldl/5, include/3, maplist/3, maplist/4]).
:- use_module(library(assoc),
              [ empty_assoc/1, gen_assoc/3, get_assoc/3, list_to_assoc/2,
                put_assoc/4
              ]).
:- use_module(library(error), [must_be/2]).
:- use_module(library(lists),
              [ append/2, append/3, clumped/2, member/2, nth1/3, same_length/2,
                selectchk/3, subtract/3, sum_list/2
              ]).
:- use_module(library(option), [option/2, option/3]).
:- use_module(library(pairs),
              [ group_pairs_by_key/2, pairs_keys/2, pairs_keys_values/3,
                pairs_values/2
              ]).
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
%   Options are lap(W) or lock(W), as of allowances/5, or
%   tabs(Width), tab_sides(On), as of tabs/5, default `one`, and
%   open_slits(Open): true, false, or `auto`, which
%   it is if not given: where much of the seam would be without tabs. What was
%   divided is told, except with told(false).
%
%   @error usage_error(pattern(wide(Option, Width, Most, W-H))): where pieces
%          have to be divided, a page with room for W x H mm takes at most Most
%          for Option, one of --tabs, --lap and --lock-seam

fitted_pieces(Pieces0, Paper, Options, Fitted, Tabs) :-
    joints(Options, Width),
    (   Width = wide(_, lap)
    ->  Open = false
    ;   Width = wide(_, lock)
    ->  Open = false
    ;   option(open_slits(Open), Options, auto)
    ),
    option(fold_threshold(Flat), Options, 0.5),
    On = on(Paper, Flat),
    pieces_opened(Open, On, Width, Pieces0, Pieces1, Known),
    pieces_fitted(Pieces1, On, Width, [], Known, Fitted, Tabs),
    (   option(told(false), Options)
    ->  true
    ;   told(Width, Open, Pieces0, Pieces1, Fitted, Tabs)
    ).

%   joints(Options, Width): Width is wide(Deep,On), On as of tabs/5, or of
%   allowances/5.

joints(Options, wide(Deep,On)) :-
    (   member(On, [lap,lock]),
        Given =.. [On,Deep],
        option(Given, Options),
        Deep > 0
    ->  true
    ;   option(tabs(Deep), Options, 0),
        must_be(number, Deep),
        option(tab_sides(On), Options, one),
        must_be(oneof([one,both,alternate]), On)
    ).

%!  joint_depth(+Options, -Joint, -Deep) is det.
%
%   Deep, in millimetres, is how far pieces may reach beyond their sides with
%   what joins them, as of fitted_pieces/5; Joint is wide(Width,On) of it.

joint_depth(Options, Joint, Deep) :-
    joints(Options, Joint),
    Joint = wide(Width, On),
    joint_reach(On, Width, Deep).

joint_reach(On, Width, Deep) :-
    (   strip_depth(On, Width, Deep)
    ->  true
    ;   Deep = Width
    ).

%!  joint_is_wide(+Joint, +Most, +Deep, +W, +H) is failure.
%
%   A page with room for W x H mm takes what is Most deep, and not Joint, which
%   is Deep.
%
%   @error usage_error(pattern(wide(Option, Width, Most, W-H)))

joint_is_wide(wide(Width,On), Most, Deep, W, H) :-
    once(joint_option(On, Option)),
    Whole is floor(min(Most, Most*Width/Deep)),
    throw(error(usage_error(pattern(wide(Option, Width, Whole, W-H))), _)).

joint_option(lap,  '--lap').
joint_option(lock, '--lock-seam').
joint_option(_,    '--tabs').

told(wide(Deep,Joint), Open, Pieces0, Pieces1, Fitted, Tabs) :-
    told_opened(Open, Pieces0, Pieces1),
    told_more(divided, Pieces1, Fitted),
    Tabs = tabs(_, Butt),
    (   memberchk(Joint, [lap,lock])
    ->  told_butt(Pieces1, Joint, [], Butt)
    ;   fitted_reasons(Deep, Fitted, Butt, Whys),
        (   Open == true
        ->  Help = none
        ;   Help = open_slits
        ),
        told_butt(Pieces1, Help, Whys, Butt)
    ).

fitted_reasons(Deep, Fitted, Butt, Whys) :-
    (   empty_assoc(Butt)
    ->  Whys = []
    ;   findall(Piece, member(fitted(Piece,_), Fitted), Pieces),
        butt_reasons(Deep, Pieces, Butt, Whys)
    ).

told_opened(Open, Before, After) :-
    (   Open == auto
    ->  told_more(opened_by_itself, Before, After)
    ;   told_more(opened, Before, After)
    ).

told_more(What, Before, After) :-
    length(Before, N0),
    length(After, N),
    (   N > N0
    ->  Told =.. [What,N0,N],
        print_message(warning, sanggwan(pattern(Told)))
    ;   true
    ).

%   told_butt(Pieces, Help, Whys, Butt): seams without tabs are told by their
%   edges, pattern by pattern, with the share of the seam that they are, and
%   how many there are of each of Whys (butt_reasons/4); Pieces are as they
%   were before they were divided. Help is `open_slits` if these may still be
%   parted.

told_butt(Pieces, Help0, Whys, Butt) :-
    findall(D-E, gen_assoc(D-_, Butt, E), Pairs),
    group_pairs_by_key(Pairs, Groups),
    forall(member(D-Es0, Groups),
           ( length(Es0, N),
             sort(Es0, Es1),
             subtract(Es1, [0], Es),
             include(is_of(D), Pieces, Own),
             seam_lengths(Own, Butt, Without, All),
             Share is 100*Without/All,
             findall(Why-D, member(Why-(D-_), Whys), Ws0),
             msort(Ws0, Ws),
             pairs_keys(Ws, Keys),
             clumped(Keys, Counts),
             helped_by(Help0, Counts, Help),
             print_message(informational,
                           sanggwan(pattern(without_tab(D, N, Share, Counts,
                                                        Help, Es)))) )).

%   Parting pieces makes no short seam longer.

helped_by(open_slits, Counts, none) :-
    \+ memberchk(slit-_, Counts),
    \+ memberchk(taken-_, Counts),
    !.
helped_by(Help, _, Help).

is_of(D, piece(name(D,_,_),_,_)).

%   seam_lengths(Pieces, Butt, Without, All): the length of the seams of Pieces
%   that are in Butt, and of all of them.

seam_lengths(Pieces, Butt, Without, All) :-
    findall(Length-Own,
            ( member(piece(name(D,_,_),_,Sides), Pieces),
              member(Side, Sides),
              Side = side(_,_,_,_,seam(J,_,1)),
              side_length(Side, Length),
              (   get_assoc(D-J, Butt, _)
              ->  Own = Length
              ;   Own = 0
              )
            ),
            Lengths),
    pairs_keys_values(Lengths, Alls, Withouts),
    sum_list(Alls, All),
    sum_list(Withouts, Without).


                /*******************************
                *            SLITS             *
                *******************************/

%   pieces_opened(Open, On, Width, Pieces0, Pieces, Known): On is
%   on(Paper,Flat), as of split_piece/4; parting a piece moves tabs, which may
%   close other slits. Known is Pieces-Tabs as of pieces_tabs/3, or `none`.

pieces_opened(false, _, _, Pieces, Pieces, none) :-
    !.
pieces_opened(_, _, wide(Deep,_), Pieces, Pieces, none) :-
    Deep =< 0,
    !.
pieces_opened(Open, on(_,Flat), Width, Pieces0, Pieces, Pieces-Tabs) :-
    findall(D-Piece, ( member(Piece, Pieces0), Piece = piece(name(D,_,_),_,_) ),
            Keyed),
    group_pairs_by_key(Keyed, Groups0),
    pairs_values(Groups0, Groups),
    maplist(pattern_opened(Open, Flat, Width), Groups, Opened, Tabss),
    append(Opened, Pieces),
    tabs_together(Tabss, Tabs).

pattern_opened(Open, Flat, Width, Pieces0, Pieces, Tabs) :-
    pieces_tabs(Width, Pieces0, Tabs0),
    rounds(Most),
    slits_opened(Most, Open-Flat, Width, Pieces0-Tabs0, Pieces1-Tabs1),
    (   is_worth_it(Open, Pieces0-Tabs0, Pieces1-Tabs1)
    ->  Pieces-Tabs = Pieces1-Tabs1
    ;   Pieces-Tabs = Pieces0-Tabs0
    ).

%   is_worth_it(Open, Before, After): less of the seam has no tab now; by
%   itself, no more than a tenth of what there was, or half of what it was:
%   seams that are too short have none among parts either.

is_worth_it(Open, Pieces0-tabs(_,Butt0), Pieces-tabs(_,Butt)) :-
    seam_lengths(Pieces0, Butt0, Without0, All0),
    seam_lengths(Pieces, Butt, Without, _),
    (   Open == true
    ->  Without < Without0
    ;   Without =< max(All0/10, Without0/2)
    ).

rounds(6).

slits_opened(N, Open-Flat, Width, Pieces0-Tabs0, Known) :-
    Tabs0 = tabs(_, Butt),
    (   N > 0,
        worth_parting(Open, Pieces0, Butt, Worth),
        long_enough(Width, Pieces0, Butt, Some),
        opened_slits(Worth, Flat, Pieces0, Some, Pieces1),
        \+ same_length(Pieces0, Pieces1)
    ->  numbered_parts(Pieces1, Pieces2),
        N1 is N-1,
        pieces_tabs(Width, Pieces2, Tabs),
        slits_opened(N1, Open-Flat, Width, Pieces2-Tabs, Known)
    ;   Known = Pieces0-Tabs0
    ).

%   worth_parting(Open, Pieces, Butt, Worth): Worth is as of opened_slits/5.
%   Pieces that are connected are wanted too, so by itself a fold is only cut if
%   more than a tenth of the seam is without tabs, and where it brings some for
%   three thousandths of it; until no more than a tenth has none, also for one
%   thousandth.

worth_parting(true, _, _, worth(1,1,0)).
worth_parting(auto, Pieces, Butt, worth(Most,Least,Need)) :-
    seam_lengths(Pieces, Butt, Without, All),
    Need is 1000*Without - 100*All,
    Need > 0,
    Most is 3*All,
    Least is All.

%   long_enough(Width, Pieces, Butt, Some): those of Butt that have a tab where
%   there is room, alone or with their neighbours along a curve.

long_enough(wide(Deep,_), Pieces, Butt, Some) :-
    seam_runs(Deep, Pieces, Runs),
    findall((D-J)-run,
            ( member(Run, Runs), member(k(name(D,_,_),J,_)-_, Run) ),
            Shared),
    findall((D-J)-long,
            ( member(piece(name(D,_,_),_,Sides), Pieces),
              member(Side, Sides),
              Side = side(_,_,_,_,seam(J,_,1)),
              get_assoc(D-J, Butt, _),
              side_length(Side, Length),
              once(tab_shape(Deep, Length, _, _))
            ),
            Long),
    append(Shared, Long, Keys0),
    sort(1, @<, Keys0, Keys),
    list_to_assoc(Keys, Able),
    findall(Seam-E,
            ( gen_assoc(Seam, Butt, E), get_assoc(Seam, Able, _) ),
            Pairs),
    list_to_assoc(Pairs, Some).

tabs_together(Tabss, tabs(Tabs,Butt)) :-
    findall(Pair, ( member(tabs(Own,_), Tabss), gen_pair(Own, Pair) ), Pairs),
    findall(Pair, ( member(tabs(_,Own), Tabss), gen_pair(Own, Pair) ), Left),
    list_to_assoc(Pairs, Tabs),
    list_to_assoc(Left, Butt).

gen_pair(Assoc, Key-Value) :-
    gen_assoc(Key, Assoc, Value).

pieces_tabs(wide(Deep,On), Pieces, tabs(Tabs,Butt)) :-
    (   memberchk(On, [lap,lock])
    ->  allowances(On, Deep, Pieces, Pairs, Left)
    ;   Deep > 0
    ->  tabs(Deep, On, Pieces, Pairs, Left)
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

%   pieces_fitted(Pieces0, On, Width, Tight, Known, Fitted, Tabs): On is
%   on(Paper,Flat), as of split_piece/4. Those of Pieces0 whose places I are in
%   Tight, a list of I-Times, are divided so that there is room for tabs all
%   round their parts, and for more of them if that has not been enough before.

pieces_fitted(Pieces0, On, Width, Tight, Known, Fitted, Tabs) :-
    On = on(Paper, _),
    pieces_split(Pieces0, On, Width, Tight, Split, Origins),
    numbered_parts(Split, Pieces),
    (   Known = Pieces-Tabs0            % nothing was divided
    ->  true
    ;   pieces_tabs(Width, Pieces, Tabs0)
    ),
    Tabs0 = tabs(Outward, _),
    maplist(fitted_piece(Outward), Pieces, Fitted0),
    findall(I,
            ( nth1(N, Fitted0, fitted(_,Outline)),
              nth1(N, Origins, I),
              \+ memberchk(I-4, Tight),
              \+ outline_fits(Outline, Paper)
            ),
            More0),
    (   More0 == []
    ->  Fitted = Fitted0,
        Tabs = Tabs0
    ;   sort(More0, More),
        foldl(tighter, More, Tight, Tight1),
        pieces_fitted(Pieces0, On, Width, Tight1, Known, Fitted, Tabs)
    ).

tighter(I, Tight0, [I-Times|Tight]) :-
    (   selectchk(I-Times0, Tight0, Tight)
    ->  Times is Times0+1
    ;   Times = 1,
        Tight = Tight0
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

pieces_split(Pieces0, on(Paper,Flat), Width, Tight, Split, Origins) :-
    findall(I-Part,
            ( nth1(I, Pieces0, Piece),
              (   memberchk(I-Times, Tight)
              ->  tab_room(Paper, Width, Pieces0, Times, Narrow),
                  split_piece(Piece, Narrow, Flat, Parts)
              ;   split_piece(Piece, Paper, Flat, Parts)
              ),
              member(Part, Parts)
            ),
            Pairs),
    pairs_keys_values(Pairs, Origins, Split).

%   tab_room(Paper, Width, Pieces, Times, Narrow): what is left of Paper if a
%   piece grows by a tab on each side, as deep as the longest seam may have one,
%   and by as much as half the room for each of more Times.

tab_room(room(W0,H0,Gap), wide(Width,On), Pieces, Times, room(W,H,Gap)) :-
    (   strip_depth(On, Width, Deep)
    ->  true
    ;   deepest_tab(Width, Pieces, Deep)
    ),
    Most is min(W0, H0)/4,
    (   Deep =< Most
    ->  Off is min(2*Most, (1+Times)*Deep),
        W is W0-Off,
        H is H0-Off
    ;   joint_is_wide(wide(Width,On), Most, Deep, W0, H0)
    ).
