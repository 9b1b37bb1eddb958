using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>Rows of contents, of a store or of an archive.</summary>
internal static class ContentRow
{
    /// <summary>The columns that <see cref="Read"/> reads, in this order.</summary>
    public const string Columns = "bytes, form, length, source, made_by";

    /// <summary>Reads a row's content.</summary>
    public static PackedContent Read(DbDataReader row) => new(
        row.GetFieldValue<byte[]>(0), row.TextOrNull(1), row.IsDBNull(2) ? null : row.GetInt64(2), row.TextOrNull(3), row.TextOrNull(4));

    /// <summary>Reads a row's content; null if somebody else wrote the row and it cannot be read.</summary>
    public static PackedContent? ReadOrNull(DbDataReader row)
    {
        try
        {
            return Read(row);
        }
        catch (Exception e) when (e is InvalidCastException or FormatException or OverflowException or InvalidOperationException)
        {
            return null;
        }
    }
}
