using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>Contents that a store keeps by their SHA-256.</summary>
internal static class StoredContent
{
    /// <summary>The hash of a content, as 64 lowercase hexadecimal digits.</summary>
    public static string Sha256(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    /// <summary>Stores a content unless it is already stored.</summary>
    public static void Keep(StoreTransaction transaction, string sha256, ReadOnlyMemory<byte> bytes) =>
        transaction.Execute(
            "INSERT INTO content (sha256, bytes) VALUES (@sha256, @Bytes) ON CONFLICT (sha256) DO NOTHING",
            new { sha256, Bytes = bytes.ToArray() });

    /// <summary>True if content is stored under a hash.</summary>
    public static bool Has(CellDatabase database, string sha256) => database.Read(connection => Rows.First(
        connection, "SELECT sha256 FROM content WHERE sha256 = @sha256", r => r.GetString(0), new { sha256 })) is not null;

    /// <summary>The content stored under a hash.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Missing"/> or <see cref="StoreError.Damaged"/>.</exception>
    public static byte[] Read(CellDatabase database, string sha256)
    {
        var bytes = database.Read(connection => Rows.First(
            connection, "SELECT bytes FROM content WHERE sha256 = @sha256", r => r.GetFieldValue<byte[]>(0), new { sha256 }))
            ?? throw new StoreException(StoreError.Missing, $"{database.Place} has no content {sha256}.");
        if (Sha256(bytes) != sha256)
        {
            throw new StoreException(
                StoreError.Damaged,
                $"{database.Place} is damaged: content {sha256} is not what was kept, but {Sha256(bytes)}. Restore the latest backup.");
        }

        return bytes;
    }
}
