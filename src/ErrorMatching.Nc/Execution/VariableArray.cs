namespace ErrorMatching.Nc;

/// <summary>A defined variable: one value, or the values of an array row by row.</summary>
internal sealed class VariableArray
{
    /// <summary>Most elements of an array.</summary>
    public const int MaxLength = 100_000;

    public VariableArray(VariableType type, int rows, int columns)
    {
        (Type, Columns) = (type, columns);
        Values = new NcValue[rows * columns];
        Array.Fill(Values, type switch { VariableType.Text => NcValue.Of(""), VariableType.Opaque => NcValue.Unknown, _ => NcValue.Zero });
    }

    public VariableType Type { get; }

    public int Columns { get; }

    public NcValue[] Values { get; }

    /// <summary>The value as the variable keeps it: whole, true or false where its type says so.</summary>
    public NcValue Converted(NcValue value) => (Type, value.Kind) switch
    {
        (VariableType.Opaque, _) => NcValue.Unknown,
        (VariableType.Integer, NcValueKind.Number) => NcValue.Of(Math.Round(value.Number, MidpointRounding.AwayFromZero)),
        (VariableType.Truth, NcValueKind.Number) => NcValue.Of(value.Number != 0),
        _ => value,
    };
}
