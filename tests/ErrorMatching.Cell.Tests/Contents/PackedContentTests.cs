using System.IO.Compression;
using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class PackedContentTests
{
    private static readonly byte[] Text = Encoding.UTF8.GetBytes(
        string.Concat(Enumerable.Range(0, 2000).Select(i => $"N{i} X{i % 7}.5\n")));

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(300)]
    [InlineData(20_000)]
    public void A_content_returns_byte_for_byte(int length)
    {
        var random = new byte[length];
        new Random(length).NextBytes(random);
        foreach (var plain in new[] { random, Text[..length], new byte[length] })
        {
            var packed = PackedContent.Of(plain);
            Assert.Equal(plain, packed.Plain());
            Assert.True(packed.Bytes.Length <= plain.Length);
        }
    }

    [Fact]
    public void Text_is_stored_compressed_and_noise_as_it_is()
    {
        var random = new byte[5000];
        new Random(1).NextBytes(random);
        Assert.Equal(new(random), PackedContent.Of(random) with { Bytes = random });
        var packed = PackedContent.Of(Text);
        Assert.Equal((PackedContent.Brotli, (long)Text.Length), (packed.Form, packed.Length));
        Assert.True(packed.Bytes.Length < Text.Length / 4);
    }

    // 64 MB of zeros in some bytes.
    [Fact]
    public void A_content_never_grows_beyond_its_recorded_length()
    {
        var bomb = new byte[1000];
        Assert.True(BrotliEncoder.TryCompress(new byte[64 << 20], bomb, out var written, 5, 22));
        var before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Null(new PackedContent(bomb[..written], PackedContent.Brotli, 5000).Plain());
        Assert.True(GC.GetAllocatedBytesForCurrentThread() - before < 100_000);
    }

    [Theory]
    [InlineData(long.MaxValue)]
    [InlineData((long)int.MaxValue)]
    [InlineData(-1L)]
    [InlineData(null)]
    public void A_recorded_length_that_is_wrong_reserves_no_memory(long? length)
    {
        var packed = PackedContent.Of(Text) with { Length = length };
        var before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Null(packed.Plain());
        Assert.True(GC.GetAllocatedBytesForCurrentThread() - before < 1_000_000);
    }

    [Theory]
    [InlineData("zip")]
    [InlineData("")]
    [InlineData(PackedContent.Archive)]
    public void An_unknown_form_is_no_content(string form) => Assert.Null((PackedContent.Of(Text) with { Form = form }).Plain());

    [Fact]
    public void Bytes_that_were_cut_off_or_added_are_noticed()
    {
        var packed = PackedContent.Of(Text);
        Assert.Null((packed with { Bytes = packed.Bytes[..^1] }).Plain());
        Assert.Null((packed with { Bytes = [.. packed.Bytes, 0] }).Plain());
        Assert.Null((packed with { Length = packed.Length - 1 }).Plain());
        Assert.Null((packed with { Length = packed.Length + 1 }).Plain());
    }
}
