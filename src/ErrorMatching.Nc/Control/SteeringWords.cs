namespace ErrorMatching.Nc;

/// <summary>Words of a block that determine how the program continues: they call, return, end or begin a program.</summary>
internal sealed class SteeringWords(BlockValues values, ProgramRun run)
{
    /// <summary>True for plain words that call, return, end or begin a program. The end of a program without calls does not need the
    /// flow's index.</summary>
    public bool ConcernFlow()
    {
        var isNamed = values.Words.Has('O') || (values.Words.Has('L') && values.Dialect.Syntax == NcSyntax.Siemens);
        foreach (var function in values.Words.Functions)
        {
            switch (values.Dialect.FunctionOf(function))
            {
                case FunctionRole.ProgramEnd or FunctionRole.Return when !run.HasFlow && !values.Words.Has('P'):
                    run.HasEnded = true;
                    break;
                case var role when role.Steers():
                    isNamed = true;
                    break;
            }
        }

        foreach (var code in values.Words.Codes)
        {
            isNamed |= values.Dialect.MeaningOf(code).Steers();
        }

        return isNamed;
    }

    /// <summary>Whether the words of the block determine how the program continues. A call by an address that is one word among others is
    /// not executed.</summary>
    public bool AreThere()
    {
        var steers = values.Dialect.Syntax == NcSyntax.Siemens && values.Dialect.RoleOf((byte)'L') == LetterRole.Program
            && ((values.Words.Present | values.Words.Computed) & BlockWords.Bit('L')) != 0;
        foreach (var function in values.Words.Functions)
        {
            steers |= values.Dialect.FunctionOf(function).Steers();
        }

        foreach (var code in values.Words.Codes)
        {
            steers |= values.Dialect.MeaningOf(code).Steers();
        }

        return steers;
    }

    /// <summary>Handles a call of a program of the machine: its effect is unknown, but it is not missing.</summary>
    public bool CallMachineProgram()
    {
        var calls = false;
        foreach (var function in values.Words.Functions)
        {
            calls |= values.Dialect.FunctionOf(function) == FunctionRole.Call;
        }

        foreach (var code in values.Words.Codes)
        {
            // A modal call still counts as missing: nothing would be known of any later motion.
            calls |= values.Dialect.MeaningOf(code) is NcMeaning.Call;
        }

        return (calls && values.Words.Has('P')
            && values.Dialect.IsMachineProgram((int)Math.Clamp(values.Words.Value('P'), -1, int.MaxValue)))
            || (values.Dialect.Syntax == NcSyntax.Siemens && values.Words.Has('L')
                && values.Dialect.IsMachineProgram((int)Math.Clamp(values.Words.Value('L'), -1, int.MaxValue)));
    }

    /// <summary>Siemens writes plain addresses with an equals sign too; those matter only to the interpreter.</summary>
    public bool HasStatements(NcBlock block)
    {
        if (values.Dialect.Syntax != NcSyntax.Siemens)
        {
            return true;
        }

        foreach (var token in run.Text.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Keyword or NcTokenKind.Assignment or NcTokenKind.Expression or NcTokenKind.ExpressionWord
                or NcTokenKind.Percent
                || token is { Kind: NcTokenKind.Word, Letter: (byte)'M' or (byte)'L' }
                    || (token.Kind == NcTokenKind.CommaWord && token.Number == default))
            {
                return true;
            }
        }

        return false;
    }
}
