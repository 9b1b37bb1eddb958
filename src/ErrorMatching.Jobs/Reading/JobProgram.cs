using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>A job's program, interpreted.</summary>
/// <param name="File">The program as a path from the caller's folder.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="OwnDialect">The job's dialect if it names a file of the shop; otherwise null.</param>
/// <param name="Called">The programs that it calls.</param>
/// <param name="Path">Its path.</param>
internal sealed record JobProgram(string File, ReadOnlyMemory<byte> Bytes, NcDialect? OwnDialect, ProgramFolder Called, NcPath Path);
