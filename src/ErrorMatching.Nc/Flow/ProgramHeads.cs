namespace ErrorMatching.Nc;

/// <summary>The names at the heads of the programs in a file: what the control will call them.</summary>
public static class ProgramHeads
{
    /// <summary>The names, in the order of the programs, each once: <c>O0100</c> for O100, <c>_N_P100_MPF</c>, the name after
    /// <c>BEGIN PGM</c>. Empty if there are none, or if the control names programs by their files alone.</summary>
    /// <param name="program">The program, with all that follows it in its file.</param>
    /// <param name="dialect">The control's dialect.</param>
    public static IReadOnlyList<string> Of(NcProgram program, NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(dialect);
        var names = new List<string>();
        if (dialect.ProgramNaming == ProgramNaming.ByFile)
        {
            return names;
        }

        var known = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        for (var i = Leader.BlocksOf(program, dialect); i < program.BlockCount; i++)
        {
            var text = program.BytesOf(program[i]);
            if (NameOf(text, BlockHead.Read(text, dialect.Syntax).At, dialect.Syntax) is { Length: > 0 } name && known.Add(name))
            {
                names.Add(name);
            }
        }

        return names;
    }

    private static string? NameOf(ReadOnlySpan<byte> text, int at, NcSyntax syntax)
    {
        if (at >= text.Length)
        {
            return null;
        }

        if (LanguageSpelling.Of(syntax) is { } language)
        {
            return language.HeadAt(text, at);
        }

        // In the ISO code, a colon may be written for the letter O.
        return syntax == NcSyntax.Iso && text[at] == ':' && BlockHead.NumberAt(text, at + 1) is { Length: > 0 } number
            ? FlowIndex.NumberName(number.Value)
            : FlowIndex.HeadingOf(text, at, syntax);
    }
}
