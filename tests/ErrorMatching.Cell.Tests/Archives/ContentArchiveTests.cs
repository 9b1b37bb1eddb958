using System.IO.Compression;
using System.Security.Cryptography;
using ErrorMatching.Testing;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell.Tests;

/// <summary>An archive that somebody else wrote: it takes no more memory than the store's own length of a content.</summary>
public sealed class ContentArchiveTests
{
    private const int Large = 32 << 20;
    private static readonly byte[] Kept = [.. Enumerable.Range(0, 5000).Select(i => (byte)(i * i))];
    private static readonly string Hash = Convert.ToHexStringLower(SHA256.HashData(Kept));

    [Fact]
    public void A_content_is_read_by_its_hash_and_length()
    {
        using var folder = new TemporaryFolder();
        using var archive = Written(folder, Kept, null, null);
        Assert.Equal(Kept, archive.Plain(Hash, Kept.Length));
        Assert.Equal(StoreError.Damaged, Error(archive, Kept.Length - 1));
        Assert.Equal(StoreError.Damaged, Error(archive, Kept.Length + 1));
        Assert.Equal(StoreError.Damaged, Error(archive, null));
    }

    // The row is much larger than what was kept, as it is or compressed, whatever it says of its length.
    [Theory]
    [InlineData(null, null)]
    [InlineData(null, 5000L)]
    [InlineData(null, (long)Large)]
    [InlineData(PackedContent.Brotli, 5000L)]
    [InlineData(PackedContent.Brotli, (long)Large)]
    public void A_large_content_in_the_place_of_a_small_one_takes_no_memory(string? form, long? length)
    {
        using var folder = new TemporaryFolder();
        var bytes = new byte[Large];
        if (form is not null)
        {
            var packed = new byte[5000];
            Assert.True(BrotliEncoder.TryCompress(bytes, packed, out var written, 5, 22));
            bytes = packed[..written];
        }

        using var archive = Written(folder, bytes, form, length);
        var before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Equal(StoreError.Damaged, Error(archive, Kept.Length));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
    }

    private static StoreError Error(ContentArchive archive, long? length) =>
        Assert.Throws<StoreException>(() => archive.Plain(Hash, length)).Error;

    private static ContentArchive Written(TemporaryFolder folder, byte[] bytes, string? form, long? length)
    {
        const string name = "contents-0123456789abcdef.db";
        using (var connection = new SqliteConnection($"Data Source={folder[name]};Pooling=False"))
        {
            connection.Open();
            connection.Execute(FormattableString.Invariant($"PRAGMA application_id = {ContentArchive.ApplicationId}"));
            connection.Execute(ContentArchive.Table);
            connection.Execute(
                "INSERT INTO content VALUES (@Hash, @bytes, @form, @length)",
                [("Hash", Hash), ("bytes", bytes), ("form", form), ("length", length)]);
        }

        return ContentArchive.Open(folder.Path, name);
    }
}
