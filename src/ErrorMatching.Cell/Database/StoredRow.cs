namespace ErrorMatching.Cell;

/// <summary>A row of the store with its stored code.</summary>
/// <typeparam name="T">Type of the row's value.</typeparam>
/// <param name="Value">The row's value.</param>
/// <param name="Coded">The row in coded form.</param>
/// <param name="Code">The stored code; null for none.</param>
internal sealed record StoredRow<T>(T Value, CodedRow Coded, string? Code)
{
    /// <summary>Creates a row from its value and its coding function.</summary>
    public StoredRow(T value, Func<T, CodedRow> coded, string? code)
        : this(value, coded(value), code)
    {
    }

    /// <summary>False if a program without the key wrote the row. Without a key this cannot be verified, and the result is true.</summary>
    public bool Holds(byte[]? key) => key is null || (Code is not null && Code == Coded.Code(key));
}
