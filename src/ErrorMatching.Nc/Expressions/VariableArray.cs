namespace ErrorMatching.Nc;

/// <summary>A defined variable: one value, or the values of an array row by row.</summary>
internal sealed class VariableArray
{
    /// <summary>Maximum number of elements of an array.</summary>
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

    /// <summary>The value as the variable stores it: an integer or a truth value if its type requires it.</summary>
    public NcValue Converted(NcValue value) => (Type, value.Kind) switch
    {
        (VariableType.Opaque, _) => NcValue.Unknown,
        (VariableType.Integer, NcValueKind.Number) => NcValue.Of(Math.Round(value.Number, MidpointRounding.AwayFromZero)),
        (VariableType.Truth, NcValueKind.Number) => NcValue.Of(value.Number != 0),
        _ => value,
    };
}

/// <summary>Type of a defined variable (Siemens DEF).</summary>
internal enum VariableType : byte
{
    Real,

    /// <summary>Integer: assigned values are rounded.</summary>
    Integer,

    /// <summary>1 or 0.</summary>
    Truth,
    Text,

    /// <summary>Axes and frames: their values are not followed.</summary>
    Opaque,
}
