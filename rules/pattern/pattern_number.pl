:- module(sg_pattern_number,
          [ seam_numbers/2,             % +Pieces, -Numbers
            partner_sheets/3,           % +Numbers, +Sheets, -Partners
            seam_strands/2,             % +Pieces, -Strands
            reads_turned/1              % +Number
          ]).
:- use_module('../store', [segment/3]).
:- use_module(pattern_outline, [cut_loops/2]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(assoc), [gen_assoc/3, get_assoc/3, list_to_assoc/2]).
:- use_module(library(lists),
              [append/3, last/2, member/2, nth1/3, reverse/2, select/3]).
:- use_module(library(pairs), [group_pairs_by_key/2, pairs_values/2]).
/** <module> The numbers of seams.

Short seams that follow each other on both sides, with hardly a bend, are the
facets of a curve: they are one seam for who glues it, and have one number, in
its middle.

Numbers run along edges, and who cuts a piece out turns it: a 6 that stands on
its head is a 9. Those that read as others so are underlined, as is usual.

A side of a seam is k(Name,J,Which), of the piece Name. Its follower is the next
side round the piece; a strand is a list of sides each of which is followed by
the next. The partners of a strand are a strand too, the other way round.
*/

:- set_prolog_flag(optimise, true).

% Sides that are shorter, in millimetres, and bend less, in degrees, are facets;
% those of a true pattern, however long.
facet_length(12.0).
facet_bend(35.0).
curve_bend(10.0).

%!  seam_numbers(+Pieces, -Numbers) is det.
%
%   Numbers is an assoc from the names of pieces to lists of N-Seams, one for
%   each strand: number N, from 1, is to be written at one of Seams, J-Which,
%   the first that has room. Those of the model come first, then those that the
%   sheet made.

seam_numbers(Pieces, Numbers) :-
    linked_seams(Pieces, Keys, Links, _),
    strands(Keys, Links, Strands),
    findall(Seam-Strand,
            ( member(Strand, Strands), strand_seam(Strand, Seam) ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall(Name-(N-Seams),
            ( nth1(N, Groups, _-Group),
              member(Strand, Group),
              Strand = [k(Name,_,_)|_],
              strand_seams(Strand, Seams)
            ),
            Numbered0),
    keysort(Numbered0, Numbered),
    group_pairs_by_key(Numbered, ByPiece),
    list_to_assoc(ByPiece, Numbers).

%!  partner_sheets(+Numbers, +Sheets:list, -Partners) is det.
%
%   Partners is an assoc of N-Name to the sheet that has the partners of number
%   N on piece Name, where that is one other than its own. Numbers are those of
%   seam_numbers/2, Sheets is a list of Name-Sheet.

partner_sheets(Numbers, Sheets, Partners) :-
    list_to_assoc(Sheets, On),
    findall(N-(Name-Sheet),
            ( gen_assoc(Name, Numbers, Own),
              get_assoc(Name, On, Sheet),
              member(N-_, Own)
            ),
            Pairs0),
    keysort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    findall((N-Name)-Sheet,
            ( member(N-Sides, Groups),
              select(Name-Here, Sides, Others),
              findall(There, member(_-There, Others), Theres),
              sort(Theres, [Sheet]),
              Sheet \== Here
            ),
            Found),
    list_to_assoc_of(Found, Partners).

%!  seam_strands(+Pieces, -Strands) is det.
%
%   Strands are lists of Key-Partner, one for each strand and its partner
%   together: Key, k(Name,J,Which), is a side of the one that comes first in the
%   standard order, Partner that of the other. Seams with more than two sides,
%   since a face was divided, are in none.

seam_strands(Pieces, Strands) :-
    linked_seams(Pieces, Keys, Links, Sides),
    strands(Keys, Links, Strands0),
    findall(Strand,
            ( member(Strand0, Strands0),
              maplist(with_partner(Sides), Strand0, Strand),
              Strand = [First1-_|_],
              last(Strand, _-First2),
              First1 @< First2
            ),
            Strands).

with_partner(Sides, Key, Key-Partner) :-
    partner(Key, Sides, Partner),
    Partner = k(_, J, Which),
    Key = k(name(D,_,_), _, _),
    \+ get_assoc(many(D,J,Which), Sides, _),
    Other is 3-Which,
    \+ get_assoc(many(D,J,Other), Sides, _).

%   linked_seams(Pieces, Keys, Links, Sides): Links are Key-Next, both the
%   followers of each other's partners. Sides is an assoc of seam(D,J,Which) to
%   a Key, and of many(D,J,Which) where there are several.

linked_seams(Pieces, Keys, Links, Sides) :-
    findall(Key-(A-B), seam_place(Pieces, Key, A, B), Places0),
    list_to_assoc_of(Places0, Places),
    findall(seam(D,J,Which)-Key,
            ( member(Key-_, Places0), Key = k(name(D,_,_),J,Which) ),
            Sides0),
    msort(Sides0, Sides1),
    findall(many(D,J,Which)-true,
            append(_, [seam(D,J,Which)-_,seam(D,J,Which)-_|_], Sides1),
            Many),
    append(Sides0, Many, Sides2),
    list_to_assoc_of(Sides2, Sides),
    findall(Key-Next, follower(Pieces, Places, Key, Next), Followers0),
    list_to_assoc_of(Followers0, Followers),
    findall(Key-Next,
            ( member(Key-Next, Followers0),
              partner(Key, Sides, Partner),
              partner(Next, Sides, Before),
              get_assoc(Before, Followers, Partner)
            ),
            Links),
    findall(Key, member(Key-_, Places0), Keys).

list_to_assoc_of(Pairs0, Assoc) :-
    sort(1, @<, Pairs0, Pairs),
    list_to_assoc(Pairs, Assoc).

seam_place(Pieces, k(Name,J,Which), A, B) :-
    member(piece(Name,_,Sides), Pieces),
    member(side(_,_,_-A,_-B,seam(J,_,Which)), Sides).

%   The other side may be on another piece of the same pattern.

partner(k(name(D,_,_),J,Which), Sides, Partner) :-
    Other is 3-Which,
    get_assoc(seam(D,J,Other), Sides, Partner).

follower(Pieces, Places, k(Name,J1,W1), k(Name,J2,W2)) :-
    member(piece(Name,_,Sides), Pieces),
    cut_loops(Sides, Loops),
    member(Loop, Loops),
    last(Loop, Last),
    append(_, [side(_,_,_,_,seam(J1,_,W1)),side(_,_,_,_,seam(J2,_,W2))|_],
           [Last|Loop]),
    get_assoc(k(Name,J1,W1), Places, Place1),
    get_assoc(k(Name,J2,W2), Places, Place2),
    goes_on(Name, Place1, Place2).

goes_on(name(D,_,_), (XA-YA)-(XB-YB), (XB-YB)-(XC-YC)) :-
    (   segment(D, _, true_development(_, _))
    ->  Most = inf,
        curve_bend(Bend)
    ;   facet_length(Most),
        facet_bend(Bend)
    ),
    X1 is XB-XA, Y1 is YB-YA,
    X2 is XC-XB, Y2 is YC-YB,
    Length1 is sqrt(X1*X1+Y1*Y1),
    Length2 is sqrt(X2*X2+Y2*Y2),
    max(Length1, Length2) < Most,
    X1*X2+Y1*Y2 > cos(Bend*pi/180)*Length1*Length2.

%   strands(Keys, Links, Strands): all Keys, in chains; a ring begins anywhere.

strands(Keys, Links, Strands) :-
    list_to_assoc_of(Links, Next),
    findall(B-true, member(_-B, Links), Followed0),
    list_to_assoc_of(Followed0, Followed),
    findall(Strand,
            ( member(Key, Keys),
              \+ get_assoc(Key, Followed, _),
              strand(Key, Next, Strand)
            ),
            Chains),
    findall(Key-true, ( member(Chain, Chains), member(Key, Chain) ), Used0),
    list_to_assoc_of(Used0, Used),
    findall([Key], ( member(Key, Keys), \+ get_assoc(Key, Used, _) ), Rings),
    append(Chains, Rings, Strands).

strand(Key, Next, [Key|Strand]) :-
    (   get_assoc(Key, Next, Key1)
    ->  strand(Key1, Next, Strand)
    ;   Strand = []
    ).

%   Both strands of a seam have the same first joint.

strand_seam(Strand, D-J) :-
    Strand = [k(name(D,_,_),_,_)|_],
    findall(J1, member(k(_,J1,_), Strand), Js0),
    msort(Js0, [J|_]).

%   The middle of the strand first; on both strands at the same joint.

strand_seams(Strand, Seams) :-
    length(Strand, N),
    findall(rank(Off,J)-(J-Which),
            ( nth1(I, Strand, k(_,J,Which)),
              Off is abs(2*I-N-1)
            ),
            Ranked0),
    keysort(Ranked0, Ranked),
    pairs_values(Ranked, Seams).

%!  reads_turned(+Number) is semidet.
%
%   True when Number, a natural number, is another one if it is read upside
%   down: 6 and 9, 68 and 89, 16 and 91. One that ends in 0 is not: no number
%   begins so.

reads_turned(Number) :-
    number_chars(Number, Digits),
    maplist(digit_turned, Digits, Turned),
    reverse(Turned, Digits1),
    Digits1 \== Digits,
    Digits1 \= ['0'|_].

digit_turned('0', '0').
digit_turned('1', '1').
digit_turned('6', '9').
digit_turned('8', '8').
digit_turned('9', '6').
