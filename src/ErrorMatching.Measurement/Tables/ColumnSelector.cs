using System.Globalization;

namespace ErrorMatching.Measurement;

/// <summary>Selects a column of a table by name or position.</summary>
public readonly record struct ColumnSelector
{
    private readonly string? _other;

    private ColumnSelector(string? name, int position, string? other = null) => (Name, Position, _other) = (name, position, other);

    /// <summary>True if the other name counts only where no column has the first one.</summary>
    internal bool PrefersName { get; private init; }

    /// <summary>Name in the header line, case ignored; null if the column is given by position.</summary>
    public string? Name { get; }

    /// <summary>Position from 1; 0 if the column is given by name.</summary>
    public int Position { get; }

    /// <summary>The accepted names, if the column is given by name.</summary>
    internal IReadOnlyList<string> Names => Name is null ? [] : _other is null ? [Name] : [Name, _other];

    /// <summary>Selects a column by name.</summary>
    public static ColumnSelector Named(string name) => new(name, 0);

    /// <summary>Selects a column that has one of two names.</summary>
    internal static ColumnSelector Either(string name, string other) => new(name, 0, other);

    /// <summary>Selects a column by name; one of another name where there is none.</summary>
    internal static ColumnSelector First(string name, string other) => new(name, 0, other) { PrefersName = true };

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
