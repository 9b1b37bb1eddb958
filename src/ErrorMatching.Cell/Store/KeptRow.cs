namespace ErrorMatching.Cell;

/// <summary>A row of the store with the code that it carries.</summary>
/// <typeparam name="T">What the row is read as.</typeparam>
/// <param name="Value">What is in it.</param>
/// <param name="Coded">The row as it is coded.</param>
/// <param name="Code">The code that it carries; null for none.</param>
internal sealed record KeptRow<T>(T Value, CodedRow Coded, string? Code)
{
    /// <summary>A row and the way in which it is coded.</summary>
    public KeptRow(T value, Func<T, CodedRow> coded, string? code)
        : this(value, coded(value), code)
    {
    }

    /// <summary>False if a program without the key wrote the row. Without a key nobody can tell.</summary>
    public bool Holds(byte[]? key) => key is null || (Code is not null && Code == Coded.Code(key));
}
