namespace ErrorMatching.Nc;

/// <summary>Values of a running program: variables, expressions, and the checks of counts and conditions.</summary>
internal sealed class FlowMemory(NcSyntax syntax, FlowReport report, AssumedValues? assumed = null, Func<bool?>? decide = null)
{
    private readonly ExpressionSyntax _expressions = ExpressionSyntax.Of(syntax);

    public NcVariables Variables { get; } = new(syntax, assumed);

    /// <summary>True once a condition was checked or a variable set.</summary>
    public bool HasComputed { get; set; }

    public ExpressionReader ReaderAt(ReadOnlySpan<byte> text, int at) => new(text, at, _expressions, Variables);

    /// <summary>Computes the value of a word.</summary>
    /// <param name="block">Its block.</param>
    /// <param name="text">The text of the block, up to the end of the value.</param>
    /// <param name="at">Start of the value; skips an equals sign.</param>
    /// <param name="decimals">Decimals of the address's least increment, to which ROUND rounds in a Fanuc address.</param>
    /// <param name="value">The value.</param>
    /// <returns>False if there is a refusal.</returns>
    public bool TryValue(int block, ReadOnlySpan<byte> text, int at, int decimals, out NcValue value)
    {
        var reader = new ExpressionReader(text, at, _expressions, Variables) { RoundDecimals = syntax == NcSyntax.Iso ? decimals : 0 };
        reader.Take((byte)'=');
        value = syntax == NcSyntax.Siemens ? reader.Expression() : reader.Operand();
        reader.SkipSpaces();
        if (reader.Error is null && reader.At < text.Length)
        {
            reader.Fail("the value should end here");
        }

        return Check(ref reader, block);
    }

    /// <summary>True if there is no error; otherwise sets the refusal.</summary>
    public bool Check(ref ExpressionReader reader, int block)
    {
        if (reader.Error is not null)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block,
                FormattableString.Invariant($"column {reader.ErrorAt + 1}: {reader.Error}."));
        }

        return report.Refusal is null;
    }

    /// <summary>A whole number that determines how the program continues; false, with a refusal, if there is none.</summary>
    public bool TryCount(int block, NcValue value, string what, out long count)
    {
        count = 0;
        if (value.IsUnknown)
        {
            report.Refuse(NcRefusalCodes.UnknownCondition, block, $"{what} is a value that only the machine knows.");
            return false;
        }

        var whole = Math.Round(value.Number, MidpointRounding.AwayFromZero);
        if (value.Kind == NcValueKind.Text || Math.Abs(whole) > 1e12)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block, $"{what} is no number that can be used.");
            return false;
        }

        count = (long)whole;
        return true;
    }

    /// <summary>Whether a condition is true; false, with a refusal, if it is unknown.</summary>
    public bool TryTruth(int block, ref ExpressionReader reader, NcValue value, out bool truth)
    {
        HasComputed = true;
        truth = value.Number != 0;
        if (!Check(ref reader, block))
        {
            return false;
        }

        if (value.IsUnknown)
        {
            return TryEitherWay(block, out truth);
        }

        if (value.Kind == NcValueKind.Text)
        {
            report.Refuse(NcRefusalCodes.BadExpression, block, "a text is neither true nor false.");
        }

        return report.Refusal is null;
    }

    /// <summary>Goes on where only the machine knows which way, if both ways lead to the same; otherwise refuses the program.</summary>
    public bool TryEitherWay(int block, out bool truth)
    {
        truth = false;
        var name = Variables.LastUnknown;
        if (decide?.Invoke() is { } way)
        {
            truth = way;
            return true;
        }

        report.Refuse(NcRefusalCodes.UnknownCondition, block,
            $"which way the program goes hangs on a value that only the machine knows{(name is null ? "" : $" ({name})")}, and both ways "
                + "do not lead to the same. State the value: assume in the job, --assume at the console.");
        return false;
    }

    /// <summary>P=3, P3 or P=R1 after a call or REPEAT; 1 if there is none.</summary>
    public bool TryPasses(int block, ref ExpressionReader reader, out long passes)
    {
        passes = 1;
        if (!reader.Take((byte)'P') && !reader.Take((byte)'p'))
        {
            return Check(ref reader, block);
        }

        reader.Take((byte)'=');
        var value = reader.Expression();
        return Check(ref reader, block) && TryCount(block, value, "the number of repetitions", out passes);
    }

    public bool IsVariable(ReadOnlySpan<byte> text, int at, int length)
    {
        if ((text[at] | 0x20) == 'r'
            && (length > 1 ? BlockHead.NumberAt(text, at + 1).Length == length - 1 : at + 1 < text.Length && text[at + 1] == '['))
        {
            return true;
        }

        return Variables.Names.Known(text.Slice(at, length)) is { } name && Variables.Knows(name);
    }

    public FlowAction Assigned(int block, VariablePlace place, NcValue value, int column)
    {
        var error = Variables.Write(place, value);
        return error is null ? FlowAction.Continue
            : report.Refuse(NcRefusalCodes.BadExpression, block, FormattableString.Invariant($"column {column + 1}: {error}."));
    }

    public static string Word(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        reader.SkipSpaces();
        var length = BlockHead.NameLength(text, reader.At);
        var word = NcText.Decode(text.Slice(reader.At, length)).ToUpperInvariant();
        reader.At += length;
        return word;
    }

    public static void SkipBrackets(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        if (reader.Take((byte)'['))
        {
            var close = text[reader.At..].IndexOf((byte)']');
            reader.At = close < 0 ? text.Length : reader.At + close + 1;
        }
    }

    public static VariableType? TypeOf(string word) => word switch
    {
        "REAL" => VariableType.Real,
        "INT" => VariableType.Integer,
        "BOOL" => VariableType.Truth,
        "STRING" => VariableType.Text,
        "CHAR" or "AXIS" or "FRAME" => VariableType.Opaque,
        _ => null,
    };

    /// <summary>Fails on anything but the end of a statement: the control stops there.</summary>
    public static void EndOfStatement(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        SkipComments(ref reader, text);
        if (reader.Error is null && reader.At < text.Length && text[reader.At] != ';')
        {
            reader.Fail("the statement should end here");
        }
    }

    /// <summary>Comments are allowed anywhere after the keyword and are ignored.</summary>
    public static void SkipComments(ref ExpressionReader reader, ReadOnlySpan<byte> text)
    {
        for (reader.SkipSpaces(); reader.At < text.Length && text[reader.At] == '('; reader.SkipSpaces())
        {
            var close = text[reader.At..].IndexOf((byte)')');
            reader.At = close < 0 ? text.Length : reader.At + close + 1;
        }
    }
}
