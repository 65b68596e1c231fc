:- module(png_reader,
          [ read_png/2                  % +Bytes, -Document
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
:- use_module(library(zlib)).
/* A reader of PNG, for tests: see drawing_reader.pl. */

%!  read_png(+Bytes, -Document) is det.
%
%   Document is png(W, H, Depth, Colour, Chunks, Rows): Chunks Type-Data of
%   those beside IHDR, IDAT, IEND; Rows lists of bytes, unfiltered.

read_png(Bytes, png(W,H,Depth,Colour,Chunks,Rows)) :-
    must(append([137,80,78,71,13,10,26,10], Rest, Bytes), signature),
    png_chunks(Rest, All),
    must(All = ["IHDR"-Head|_], ihdr),
    must(last(All, "IEND"-[]), iend),
    Head = [W3,W2,W1,W0,H3,H2,H1,H0,Depth,Colour,Method,Filter,Interlace],
    must([Method,Filter,Interlace] == [0,0,0], methods),
    W is W3<<24 \/ W2<<16 \/ W1<<8 \/ W0,
    H is H3<<24 \/ H2<<16 \/ H1<<8 \/ H0,
    findall(Part, member("IDAT"-Part, All), Parts),
    append(Parts, Packed),
    findall(Type-Data, ( member(Type-Data, All),
                         \+ memberchk(Type, ["IHDR","IDAT","IEND"]) ), Chunks),
    unpacked(Packed, Bits),
    must(memberchk(Colour-Channels, [0-1,2-3,3-1]), colour(Colour)),
    Length is (W*Channels*Depth+7)//8,
    Step is max(1, Channels*Depth//8),
    png_rows(Bits, H, Length, Step, Rows).

png_chunks([], []).
png_chunks([L3,L2,L1,L0|Rest], [Type-Data|Chunks]) :-
    Length is L3<<24 \/ L2<<16 \/ L1<<8 \/ L0,
    Both is Length+4,
    length(Checked, Both),
    must(append(Checked, [C3,C2,C1,C0|Rest1], Rest), chunk),
    crc32(Checked, CRC),
    must(CRC =:= C3<<24 \/ C2<<16 \/ C1<<8 \/ C0, crc),
    length(Name, 4),
    append(Name, Data, Checked),
    string_codes(Type, Name),
    png_chunks(Rest1, Chunks).

crc32(Bytes, CRC) :-
    foldl(crc_byte, Bytes, 0xFFFFFFFF, Last),
    CRC is Last xor 0xFFFFFFFF.

crc_byte(Byte, C0, C) :-
    C1 is C0 xor Byte,
    crc_bits(8, C1, C).

crc_bits(0, C, C) :-
    !.
crc_bits(N, C0, C) :-
    (   C0 /\ 1 =:= 1
    ->  C1 is (C0 >> 1) xor 0xEDB88320
    ;   C1 is C0 >> 1
    ),
    N1 is N-1,
    crc_bits(N1, C1, C).

unpacked(Packed, Bytes) :-
    setup_call_cleanup(
        tmp_file_stream(File, Out, [encoding(binary)]),
        ( format(Out, '~s', [Packed]),
          close(Out),
          setup_call_cleanup(
              ( open(File, read, In, [type(binary)]),
                zopen(In, Inflated, [format(deflate)]) ),
              read_stream_to_codes(Inflated, Bytes),
              close(Inflated))
        ),
        delete_file(File)).

png_rows(Bits, H, Length, Step, Rows) :-
    length(Zeros, Length),
    maplist(=(0), Zeros),
    png_rows(H, Bits, Length, Step, Zeros, Rows).

png_rows(0, Bits, _, _, _, []) :-
    !,
    must(Bits == [], rows).
png_rows(N, [Filter|Bits], Length, Step, Above, [Row|Rows]) :-
    length(Raw, Length),
    must(append(Raw, Rest, Bits), row(N)),
    unfiltered(Filter, Raw, Above, Step, Row),
    N1 is N-1,
    png_rows(N1, Rest, Length, Step, Row, Rows).

unfiltered(0, Row, _, _, Row) :-
    !.
unfiltered(Filter, Raw, Above, Step, Row) :-
    must(between(1, 4, Filter), filter(Filter)),
    length(Zeros, Step),
    maplist(=(0), Zeros),
    append(Zeros, Row, Lefts),
    append(Zeros, Above, Corners),
    unfiltered_(Raw, Above, Lefts, Corners, Filter, Row).

unfiltered_([], _, _, _, _, []).
unfiltered_([X|Raw], [B|Bs], [A|As], [C|Cs], Filter, [Y|Row]) :-
    guess(Filter, A, B, C, G),
    Y is (X+G) /\ 255,
    unfiltered_(Raw, Bs, As, Cs, Filter, Row).

guess(1, A, _, _, A).
guess(2, _, B, _, B).
guess(3, A, B, _, G) :-
    G is (A+B)//2.
guess(4, A, B, C, G) :-
    P is A+B-C,
    PA is abs(P-A),
    PB is abs(P-B),
    PC is abs(P-C),
    (   PA =< PB,
        PA =< PC
    ->  G = A
    ;   PB =< PC
    ->  G = B
    ;   G = C
    ).
