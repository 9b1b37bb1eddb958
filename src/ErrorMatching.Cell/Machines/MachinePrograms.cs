using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>What the control of a machine calls its programs.</summary>
internal static class MachinePrograms
{
    private static readonly string[] Endings =
        ["", ".nc", ".ngc", ".spf", ".mpf", ".cnc", ".tap", ".min", ".sub", ".ssb", ".prg", ".h", ".i", ".eia", ".txt"];

    /// <summary>All names of a program.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="file">The program's name there.</param>
    /// <param name="contents">What it contains, or contained, or will; null for nothing.</param>
    public static ProgramIdentity Identify(MachineSettings machine, string file, IEnumerable<ReadOnlyMemory<byte>?> contents)
    {
        NcDialect dialect;
        try
        {
            dialect = InputFile.Dialect(machine.Dialect);
        }
        catch (InputException)
        {
            // The configuration reports it. Until it is right, any number may be this program's.
            return new(file, ProgramNaming.ByHead, [], isUnsure: true);
        }

        var heads = contents.OfType<ReadOnlyMemory<byte>>().Select(c => HeadsOf(c, dialect)).ToArray();
        return new(
            file,
            dialect.ProgramNaming,
            [.. heads.SelectMany(h => h).Distinct(StringComparer.OrdinalIgnoreCase)],
            dialect.ProgramNaming == ProgramNaming.ByHead && heads.Any(h => h.Count == 0));
    }

    /// <summary>The content of a program that may not be there. Converted by itself, no array would be an empty program.</summary>
    public static ReadOnlyMemory<byte>? Content(byte[]? bytes) => bytes is null ? default(ReadOnlyMemory<byte>?) : bytes;

    /// <summary>A file of the machine's folder that the control could mean by a name of a program; null if there is none.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="program">The program of a slot.</param>
    /// <param name="names">The names in the folder.</param>
    public static string? OtherFile(MachineSettings machine, ProgramIdentity program, IReadOnlyList<string> names)
    {
        // A server may spell the file itself with other letters.
        var isThere = names.Contains(program.File, StringComparer.Ordinal);
        return names.FirstOrDefault(
            n => !n.Equals(program.File, isThere ? StringComparison.Ordinal : StringComparison.OrdinalIgnoreCase)
                && IsProgram(n, program.File)
                && machine.Slots.All(s => !n.Equals(s.Program, StringComparison.OrdinalIgnoreCase) && n != s.ReadyFile)
                && program.SharedWith(Identify(machine, n, [])) is not null);
    }

    // Copies that people or the control keep under other endings are no programs.
    private static bool IsProgram(string name, string like) => Path.GetExtension(name) is var ending
        && (ending.Equals(Path.GetExtension(like), StringComparison.OrdinalIgnoreCase)
            || Endings.Contains(ending, StringComparer.OrdinalIgnoreCase));

    private static IReadOnlyList<string> HeadsOf(ReadOnlyMemory<byte> content, NcDialect dialect)
    {
        try
        {
            return ProgramHeads.Of(NcProgram.Read(content, dialect.Syntax), dialect);
        }
        catch (InputException)
        {
            // Whatever it is, it states no name.
            return [];
        }
    }
}
