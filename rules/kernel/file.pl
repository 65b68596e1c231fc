:- module(sg_kernel_file, []).
:- sg_kernel:export_doors.

/** <module> Meshes and solids, from files and to them.

Foreign predicates; see kernel.pl.
*/

/* - - - text_limits_rows.c - - - */

%!  text_fault(+Kind:text_kind, +Source:text, +Limits:text_limits,
%!             -Fault:text_fault_place) is semidet.
%
%   True when the text Source, a string or a stream of a file (from its
%   beginning, wherever the stream is), is too deep or too long: Fault is the
%   first fault(What, Line, Column), What one of `depth`, `digits`, `name`
%   and `fact`. Limits is limits(Depth, Blocks, Digits, Name, Fact, File).
%   Kind is `facts`, `program`, `json`, `lines` or `octets`: see
%   c_kernels/model/text_limits.h.

%!  text_copied(+Kind:text_kind, +Begun:text, +In:input, +Out:output,
%!              +Limits:text_limits, +Most:count, -Copied:count,
%!              -Fault:text_fault_place) is det.
%
%   Writes what comes from In to Out, Most octets of it, and looks through it as
%   it comes, as what follows the text Begun. Copied octets were written: fewer
%   than Most if In is at its end, or after a Fault; its What is `none` else.

/* - - - plain_facts_rows.c - - - */

%!  plain_facts_open(+Source:text, -Facts:plain_facts) is det.
%!  plain_facts_take(+Facts:plain_facts, +Shift:int, +From:text_place,
%!                   -To:text_place) is det.
%!  plain_facts_segments(+Facts:plain_facts, -Ss:list(int)) is det.
%!  plain_facts_add(+Facts:plain_facts, +Relation:name) is semidet.
%!  plain_facts_close(+Facts:plain_facts) is det.
%
%   Facts are those of the model file Source that are plain, as of
%   c_kernels/model/plain_facts_rows.h. Those from the place From on, places of
%   the stream, are taken as long as they are; Shift is added to the numbers of
%   their segments. Ss are the segments of vertices, edges and polygons, in
%   order. plain_facts_add/2 adds the rows of a Relation, for p/3 also the edges
%   of lists of vertices. It fails if one is wrong: some may be there then.

/* - - - vertex_list_rows.c - - - */

%!  vertex_list_fault(+S:id, +Vs:list(int),
%!                    -Fault:vertex_list_fault) is semidet.
%!  chain_fault(+S:id, +Vs:list(int), -Fault:chain_fault) is semidet.
%
%   True when Vs is no list of vertices of segment S as a polygon has, or a
%   chain: Fault is `list`, it has no edges (vertex_list_edges/2); else
%   missing(V), S has no vertex V; else as polygon_fault/2 says, or chain(V), V
%   has an edge to itself.

/* - - - csg_text_rows.c - - - */

%!  csg_nodes(+Stream:input, +File:name, +Limits:text_limits,
%!            -Result:term) is det.
%
%   Reads Stream, the text of the .csg file File, to its end. Result is
%   nodes(Nodes), or fault(What, Line, Column) with What as of text_fault/4,
%   `blocks`, `file`, or an error of openscad_text.pl, which also has the form
%   of Nodes.

/* - - - mesh_rows.c - - - */

%!  mesh_add(+Stream:input, +Format:mesh_format, +Weld:mesh_weld, +One:bool,
%!           +S:id, -Result:mesh_added) is det.
%
%   Reads the octets of Stream to its end as Format (`stl`, `off`, `obj`,
%   `ply`, `any`) and adds v/5, e/5 and p/3 of the segments in it, numbered
%   from S. Weld is `auto`, `all` or `none`; One is true for one segment
%   whatever the file names. Result is one of
%
%     - loaded(Parts, Grain, passed_over(Degenerate, Repeated, Welded, Ignored,
%       IgnoredLine, Trailing))
%       Parts are part(S, Kind, Name), Name '' if the file has none; Grain is a
%       unit in the last place of the coordinates, 0.0 if they are exact.
%     - fault(Code, Line, Column, Byte, Text, Wanted, Got, Limit)
%       The file is bad, and nothing was added; see c_kernels/model/mesh.h.
%
%   @error permission_error(write, segment, S1): one of the segments has rows

/* - - - mesh_write_rows.c - - - */

%!  mesh_write(+Stream:output, +Format:mesh_format, +Segments:list(id),
%!             +Names:list(name), -Result:mesh_written) is det.
%
%   Writes the listed segments to Stream as Format (also `stl_binary`,
%   `ply_binary`). Segments ascend; Names are theirs, '' for none. Result is
%   `ok`, no_triangles(S, P): polygon P must be written as triangles and has
%   none (nothing was written), or a fault/8 as of mesh_add/6.

/* - - - simplify_rows.c - - - */

%!  simplified_open(+Segments:list(id), -Simplified:simplified) is det.
%
%   Simplified is a handle for the triangles of these segments, of which there
%   are to be fewer (c_kernels/model/simplify.h). The world is read now.

%!  simplified_run(+Simplified:simplified, +Faces:count, -Left:count) is det.
%
%   Simplify what was read to at most Faces triangles in all; Left are there
%   then, more than Faces if no more can go.

%!  simplified_weigh(+Simplified:simplified, +S:id, +Vertices:set(id),
%!                   +Factor:number) is det.
%
%   In the next run what the last one made these Vertices of segment S from
%   matters Factor times as much as before.
%
%   @error existence_error(segment, S), existence_error(vertex, Vertices)

%!  simplified_add(+Simplified:simplified, +S:id) is det.
%
%   Add the rows v/5, e/5 and p/3 of segment S as the last run left it.
%
%   @error existence_error(segment, S): it was not read, or nothing is left
%   @error permission_error(write, segment, S): it has rows

%!  simplified_close(+Simplified:simplified) is det.
%
%   Free it at once.

/* - - - boundary_rows.c - - - */

%!  boundary_open(+Segments:list(id), +Made:list(id_pair), +Single:bool,
%!                +Grid:number, +Form:boundary_form, +Copies:bool,
%!                -Boundary:boundary) is det.
%
%   Boundary is a handle for the polygons of the segments in the list, as a file
%   will hold them: coordinates as multiples of Grid (a power of two; 0.0: as
%   they are), then as float32 if Single; without what that has collapsed; in an
%   order that depends on where things are alone. See c_kernels/model/boundary.h
%   and boundary_mesh.h. Made lists S-V of vertices that cuts made: their
%   coordinates are rounded already. Form is `polygons`, `flat` (a
%   polygon of more than three corners is flat to the last digit), `triangles`,
%   or `soup`: the triangles of t/6, also those that rounding turned over, which
%   else are taken out.
%   If Copies, every edge has two faces and every vertex one fan.
%
%   @error representation_error(float32): a coordinate is too large

%!  boundary_coarsen(+Boundary:boundary, +Grid:number,
%!                   -Coarser:boundary) is det.
%
%   Coarser is another handle for Boundary, with the vertices of those triangles
%   that go through each other on multiples of Grid, and what is near these.

%!  boundary_close(+Boundary:boundary) is det.

%!  boundary_counts(+Boundary:boundary, -Counts:boundary_counts) is det.
%
%   Counts = counts(Faces, Open, Crossing, Stuck): Open edges lack an opposite;
%   at Crossing edges four or more faces go through each other; for Stuck faces
%   no triangles were found.

%!  boundary_meetings(+Boundary:boundary, +All:bool,
%!                    -Meetings:list(boundary_meeting)) is det.
%
%   Meetings are meeting(Kind, X, Y, Z), where triangles go through each other
%   (`self_penetration`) or share some area (`self_overlap`), exactly. If All,
%   also where they touch along more than an edge that they share
%   (`self_touching`): sheets may cross there. Else only meetings where one of
%   the two is not as the segment has it: rounding, a cut, or dividing a polygon
%   has made it.

%!  boundary_add(+Boundary:boundary, +S:id) is det.
%
%   Add the vertices, edges and polygons of Boundary as segment S, of several
%   segments as S, S+1, ...

%!  boundary_write(+Boundary:boundary, +Stream:output, +Format:mesh_format,
%!                 +Names:list(name), -Result:mesh_written) is det.
%
%   As mesh_write/5.

/* - - - atomic_file4pl.c - - - */

%!  atomic_open(+File, -Id:integer, -Stream) is det.
%
%   Stream, which is binary, writes what File is after atomic_commit/2 of Id:
%   beside File, under a name that nobody can guess. See engine/atomic_file.h.
%
%   @error cannot_write(File, Why): Why is `permission`, `no_folder`,
%   `directory`, `full`, `too_large`, `long_name`, `links` (in a circle), or
%   words of the system

%!  atomic_scratch(+Ending, -Id:integer, -File) is det.
%
%   File is an empty file that ends in Ending, in the folder for temporary
%   files. It vanishes with atomic_drop/1 of Id, or when the process ends.
%
%   @error cannot_write(Ending, Why)

%!  atomic_sync(+Stream) is det.
%
%   What was written to Stream is on the disk.
%
%   @error io_error(write, Stream)

%!  atomic_sync_folder(+File) is det.
%
%   The name of File in its folder is on the disk, if it can be.

%!  atomic_commit(+Ids:list(integer), -Result) is det.
%
%   Put the files of atomic_open/3 in their places, all of them or none. Result
%   is `done`, or failed(I, Why): the file number I of the list, from 0, could
%   not be put there; Why as above. Then they still wait.

%!  atomic_drop(+Id:integer) is det.
%
%   Forget the file of Id and delete what was written of it; nothing if it has
%   been put in its place.

%!  device_file(+File) is semidet.
%
%   True of a device, a pipe, a socket, links followed: what is there, but
%   neither a file nor a folder.

%!  endless_file(+File) is semidet.
%
%   True of a device that can be read without end, links followed: a disk, or
%   one of those that give octets (/dev/zero). Not of /dev/null, and not of a
%   terminal.

/* - - - stdio4pl.c - - - */

%!  stdio_apart(-In, -Out) is det.
%
%   In and Out are streams of octets on what were standard input and output.
%   From now on standard input is empty, and what is written to standard output
%   by others, such as programs that a goal starts, goes to standard error.
%
%   @error system_error(What, Why)

%!  reader_gone(+Stream) is semidet.
%
%   True when Stream writes to a pipe or a socket that nobody reads any more.

%!  passed_socket(-Path) is semidet.
%
%   True when this process was started with sockets, as systemd does it
%   (sd_listen_fds(3)): descriptors from 3 on, and LISTEN_PID and LISTEN_FDS in
%   the environment. Path is where the socket listens, '' if that is no Unix
%   socket with a name that listens, or there are more.

%!  passed_taken(+Fd:integer) is det.
%
%   Descriptor Fd, which is closed, is the socket that was passed, and nothing
%   says any more that one was.
%
%   @error system_error(What, Why)

/* - - - part4pl.c - - - */

%!  program_part(+From, +Bytes, -Stream) is semidet.
%
%   Stream reads Bytes octets, from From on, of the parts of the rules that the
%   program carries (part.pl). Plain Prolog carries none.

/* - - - subterm4pl.c - - - */

%!  has_part(+Term, +Parts) is semidet.
%
%   True when Term, an atom or a compound, or a part of it is one of Parts: a
%   compound whose arguments are atoms, and Name/Arity of compounds.
%
%   @error type_error(acyclic_term, Term)

%!  plain_value(+Term, +Depth) is semidet.
%
%   True when Term has only atoms, integers, finite floats, and Depth levels of
%   compounds at most, of which a list is one; so no variable, text or dict.
%
%   @error type_error(acyclic_term, Term)

%!  id_list(+List, +Least) is semidet.
%
%   True when List is a list of integers from Least to 2147483647, none of
%   them 0.
