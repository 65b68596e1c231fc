:- module(sg_image_text,
          [ image_base64/2,             % +Image, -Text
            image_flate/2,              % +Image, -Text
            image_lzw_text/2            % +Image, -Text
          ]).
:- use_module('../kernel', [image_lzw/2, image_png/3]).
:- use_module(library(base64), [base64_encoded/3]).
:- use_module(library(lists), [append/3]).
:- use_module(library(memfile),
              [ new_memory_file/1, open_memory_file/4, free_memory_file/1,
                memory_file_to_string/3
              ]).
/** <module> A picture in dots as text, for files that are text.
*/

%!  image_base64(+Image, -Text) is det.
%
%   Text is a PNG file of Image in base 64.

image_base64(Image, Text) :-
    png_string(Image, Bytes),
    base64_encoded(Bytes, Text, [encoding(octet),as(string)]).

png_string(Image, Bytes) :-
    written_string(Out, image_png(Image, 0, Out), Bytes).

%   written_string(Out, Goal, Bytes): Bytes are what Goal writes to Out.

written_string(Out, Goal, Bytes) :-
    setup_call_cleanup(
        new_memory_file(File),
        ( setup_call_cleanup(
              open_memory_file(File, write, Out, [encoding(octet)]),
              Goal,
              close(Out)),
          memory_file_to_string(File, Bytes, octet) ),
        free_memory_file(File)).

%!  image_flate(+Image, -Text) is det.
%
%   Text is the data of Image for the filters ASCII85Decode and FlateDecode of
%   PDF, the latter with the predictor of PNG (15): what the
%   chunks IDAT of a PNG file have. In lines, with the end `~>`.

image_flate(Image, Text) :-
    png_string(Image, Bytes),
    chunks_data(8, Bytes, Parts),
    atomic_list_concat(Parts, Data),
    text_85(Data, Text).

%!  image_lzw_text(+Image, -Text) is det.
%
%   Text is the data of Image for the filters ASCII85Decode and LZWDecode, which
%   level 2 of PostScript has.

image_lzw_text(Image, Text) :-
    written_string(Out, image_lzw(Image, Out), Bytes),
    text_85(Bytes, Text).

text_85(Bytes, Text) :-
    string_codes(Bytes, Codes),
    phrase(base_85(Codes, 0), Digits),
    string_codes(Text, Digits).

%   chunks_data(At, Bytes, Parts): the data of chunks from At on.

chunks_data(At, Bytes, Parts) :-
    TypeAt is At+4,
    DataAt is At+8,
    sub_string(Bytes, TypeAt, 4, _, Type),
    (   Type == "IEND"
    ->  Parts = []
    ;   sub_string(Bytes, At, 4, _, Size),
        string_codes(Size, [A,B,C,D]),
        Length is ((A*256+B)*256+C)*256+D,
        (   Type == "IDAT"
        ->  sub_string(Bytes, DataAt, Length, _, Data),
            Parts = [Data|Parts1]
        ;   Parts = Parts1
        ),
        Next is DataAt+Length+4,
        chunks_data(Next, Bytes, Parts1)
    ).

%   base_85(Codes, Column): four bytes are five digits; zeros are `z`; of the
%   last, if it has N bytes, N+1 digits.

base_85([A,B,C,D|Codes], Column0) -->
    !,
    { Number is ((A*256+B)*256+C)*256+D },
    (   { Number =:= 0 }
    ->  "z",
        { Column is Column0+1 }
    ;   digits(5, Number),
        { Column is Column0+5 }
    ),
    (   { Column >= 75 }
    ->  "\n",
        base_85(Codes, 0)
    ;   base_85(Codes, Column)
    ).
base_85([], _) -->
    !,
    "~>".
base_85(Rest, _) -->
    { length(Rest, N),
      padded(Rest, [A,B,C,D]),
      Number is ((A*256+B)*256+C)*256+D,
      phrase(digits(5, Number), All),
      Kept is N+1,
      length(Digits, Kept),
      append(Digits, _, All) },
    codes(Digits),
    "~>".

codes(List, All, Rest) :-
    append(List, Rest, All).

padded([A], [A,0,0,0]).
padded([A,B], [A,B,0,0]).
padded([A,B,C], [A,B,C,0]).

digits(0, _) -->
    !,
    "".
digits(N, Number) -->
    { Less is N-1,
      Above is Number//85,
      Digit is Number mod 85 + 0'! },
    digits(Less, Above),
    [Digit].
