using System.Buffers.Text;

namespace ErrorMatching.Nc;

/// <summary>Reads which variable is named in an expression.</summary>
internal static class VariableReader
{
    private const double Nearly = 0.0001;

    /// <inheritdoc cref="ExpressionReader.Place"/>
    public static VariablePlace Place(ref ExpressionReader reader)
    {
        ref var text = ref reader.Text;
        text.SkipSpaces();
        if (reader.Syntax == NcSyntax.Siemens)
        {
            return SiemensPlace(ref reader);
        }

        if (!text.Take((byte)'#'))
        {
            text.Fail("a variable is expected here");
            return VariablePlace.Machine;
        }

        text.SkipSpaces();
        if (reader.Syntax == NcSyntax.LinuxCnc && text.Peek() == '<')
        {
            return NamedPlace(ref reader);
        }

        if (!text.Deeper())
        {
            return VariablePlace.Machine;
        }

        var start = text.At;
        var number = text.Peek() switch
        {
            (byte)'#' => reader.Variable(),
            (byte)'[' => reader.Bracket(),
            (byte)'.' or (>= (byte)'0' and <= (byte)'9') => ExpressionLiterals.Number(ref text, reader.Syntax),
            var c when reader.Syntax == NcSyntax.LinuxCnc && SyntaxBytes.IsLetter(c) => reader.Operand(),
            _ => text.Fail("the number of a variable is expected here"),
        };
        text.Leave();
        return Position(ref text, number, start) is { } position ? VariablePlace.Numbered(position) : VariablePlace.Machine;
    }

    // The whole number of a variable or an array element; null if only the machine knows it.
    private static int? Position(ref ExpressionText text, NcValue value, int start)
    {
        if (text.Error is not null || value.IsUnknown)
        {
            return null;
        }

        var whole = Math.Round(value.Number);
        if (value.Kind == NcValueKind.Text || Math.Abs(value.Number - whole) > Nearly || whole is < 0 or > 99_999_999)
        {
            text.FailAt(start, "the number of a variable must be a whole number");
            return null;
        }

        return (int)whole;
    }

    private static VariablePlace NamedPlace(ref ExpressionReader reader)
    {
        ref var text = ref reader.Text;
        var length = text.Rest.IndexOf((byte)'>');
        if (length < 0)
        {
            text.Fail("the name of a variable is not closed: \">\" is missing");
            return VariablePlace.Machine;
        }

        var name = reader.Variables.Names.Of(text.Rest[1..length]);
        if (string.IsNullOrEmpty(name))
        {
            text.Fail("the name of a variable is empty or too long");
            return VariablePlace.Machine;
        }

        text.At += length + 1;
        return VariablePlace.Named(name);
    }

    private static VariablePlace SiemensPlace(ref ExpressionReader reader)
    {
        ref var text = ref reader.Text;
        var start = text.At;
        var machine = text.Peek() == '$';
        text.At += machine ? 1 : 0;
        while (ExpressionText.IsNamePart(text.Peek()) || (machine && text.Peek() == '$'))
        {
            text.At++;
        }

        var spelling = text.Since(start);
        if (spelling.Length == 0)
        {
            text.Fail("a variable is expected here");
            return VariablePlace.Machine;
        }

        if ((spelling[0] | 0x20) == 'r' && spelling.Length is > 1 and < 9 && spelling[1..].IndexOfAnyExceptInRange((byte)'0', (byte)'9') < 0
            && Utf8Parser.TryParse(spelling[1..], out int number, out _))
        {
            return VariablePlace.Numbered(number);
        }

        var name = machine ? null : reader.Variables.Names.Known(spelling);
        var known = name is null ? null : reader.Variables.Find(name);
        var isParameter = known is null && spelling.Length == 1 && (spelling[0] | 0x20) == 'r';
        if (text.Peek() == '[' && (known is not null || isParameter))
        {
            return Indexed(ref reader, name, known);
        }

        return known is null ? BehindMachineVariable(ref text, start) : VariablePlace.Named(name!);
    }

    // The brackets of machine variables (axes, keywords) are not computed.
    private static VariablePlace BehindMachineVariable(ref ExpressionText text, int start)
    {
        while (text.Peek() is (byte)'[' or (byte)'(')
        {
            var (open, close, depth) = (text.Peek(), text.Peek() == '[' ? (byte)']' : (byte)')', 0);
            do
            {
                depth += text.Peek() == open ? 1 : text.Peek() == close ? -1 : 0;
                text.At++;
            }
            while (depth > 0 && !text.IsAtEnd);

            if (depth > 0)
            {
                text.Fail("a bracket is not closed");
            }
        }

        return text.Error is null && text.Since(start) is { Length: <= VariableNames.MaxLength } name
            ? VariablePlace.OfMachine(NcText.Decode(name).Replace(" ", "", StringComparison.Ordinal).ToUpperInvariant())
            : VariablePlace.Machine;
    }

    private static VariablePlace Indexed(ref ExpressionReader reader, string? name, VariableArray? array)
    {
        ref var text = ref reader.Text;
        var start = ++text.At;
        if (!text.Deeper())
        {
            return VariablePlace.Machine;
        }

        var row = Position(ref text, reader.Expression(), start);
        var column = text.Take((byte)',') ? Position(ref text, reader.Expression(), start) : 0;
        text.Leave();
        if (!text.Take((byte)']'))
        {
            text.Fail("a bracket is not closed: \"]\" is expected here");
        }

        if (text.Error is not null || row is null || column is null)
        {
            return VariablePlace.Machine;
        }

        if (array is null)
        {
            return VariablePlace.Numbered(row.Value);
        }

        var position = ((long)row.Value * array.Columns) + column.Value;
        if (column >= array.Columns || position >= array.Values.Length)
        {
            text.FailAt(start, $"{name} has no element of this number");
            return VariablePlace.Machine;
        }

        return VariablePlace.Element(name!, (int)position);
    }
}
