using System.Globalization;

namespace ErrorMatching.Measurement;

/// <summary>Selects a column of a table by name or position.</summary>
public readonly record struct ColumnSelector
{
    private ColumnSelector(string? name, int position) => (Name, Position) = (name, position);

    /// <summary>Name in the header line, case ignored; null if the column is given by position.</summary>
    public string? Name { get; }

    /// <summary>Position from 1; 0 if the column is given by name.</summary>
    public int Position { get; }

    /// <summary>Selects a column by name.</summary>
    public static ColumnSelector Named(string name) => new(name, 0);

    /// <summary>Selects a column by position.</summary>
    /// <param name="position">Position from 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position is less than 1.</exception>
    public static ColumnSelector At(int position)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(position, 1);
        return new(null, position);
    }

    /// <summary>The name, or the position as a number.</summary>
    public override string ToString() => Name ?? Position.ToString(CultureInfo.InvariantCulture);
}
