using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class AuditChainTests
{
    private static readonly DateTimeOffset Start = new(2026, 3, 1, 6, 0, 0, TimeSpan.Zero);
    private static readonly byte[] Key = Encoding.UTF8.GetBytes("a key that is not in the store");

    [Fact]
    public void A_trail_as_it_was_written_holds()
    {
        Assert.Null(AuditChain.Verify(Chain(5), Head(Chain(5)), null));
        Assert.Null(AuditChain.Verify(Chain(5), Head(Chain(5)), Key));
        Assert.Null(AuditChain.Verify([], new AuditHead(0, Start, AuditEntry.NoHash, null), null));
    }

    [Fact]
    public void The_hash_is_that_of_the_published_form()
    {
        var entry = AuditEntry.After(AuditEntry.NoHash, 7, DateTimeOffset.UnixEpoch.AddMilliseconds(1), "änna", "approved", null, "");
        using var form = new MemoryStream();
        form.Write("errormatch audit 1"u8);
        Number(7, 8);
        Number(1000, 8);
        Number(64, 4);
        form.Write(Encoding.ASCII.GetBytes(new string('0', 64)));
        Number(5, 4);
        form.Write([0xC3, 0xA4, (byte)'n', (byte)'n', (byte)'a']);
        Number(8, 4);
        form.Write("approved"u8);
        Number(-1, 4);
        Number(0, 4);
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(form.ToArray())), entry.Hash);

        void Number(long number, int bytes)
        {
            var all = new byte[8];
            BinaryPrimitives.WriteInt64BigEndian(all, number);
            form.Write(all.AsSpan(8 - bytes));
        }
    }

    [Theory]
    [InlineData("a", "bc"), InlineData("abc", "")]
    public void No_two_entries_have_one_form(string what, string basis) => Assert.NotEqual(
        AuditEntry.After(AuditEntry.NoHash, 1, Start, "anna", "ab", "c", "c").Hash,
        AuditEntry.After(AuditEntry.NoHash, 1, Start, "anna", what, basis, "c").Hash);

    [Fact]
    public void Every_field_that_is_changed_is_found()
    {
        Func<AuditEntry, AuditEntry>[] changes =
        [
            e => e with { At = e.At.AddMicroseconds(1) },
            e => e with { Who = "eve" },
            e => e with { What = "rejected" },
            e => e with { Subject = null },
            e => e with { Subject = "" },
            e => e with { Basis = e.Basis + " " },
            e => e with { Hash = new string('a', 64) },
        ];
        foreach (var change in changes)
        {
            for (var at = 0; at < 5; at++)
            {
                var chain = Chain(5);
                chain[at] = change(chain[at]);
                Found(AuditFaultKind.Changed, at + 1, chain);
            }
        }
    }

    [Fact]
    public void An_entry_that_is_changed_with_its_own_hash_is_found()
    {
        for (var at = 0; at < 5; at++)
        {
            var chain = Chain(5);
            var forged = chain[at] with { Who = "eve" };
            chain[at] = forged with { Hash = forged.HashAs(forged.Seq) };
            Found(AuditFaultKind.Changed, at + 1, chain);
        }
    }

    [Fact]
    public void A_link_that_is_changed_is_found()
    {
        var chain = Chain(5);
        chain[2] = chain[2] with { Previous = new string('b', 64) };
        Found(AuditFaultKind.Changed, 3, chain);
    }

    [Theory]
    [InlineData(false), InlineData(true)]
    public void Removed_entries_are_found(bool numberedAnew)
    {
        for (var at = 0; at < 5; at++)
        {
            for (var count = 1; at + count <= 5; count++)
            {
                var chain = Chain(5);
                chain.RemoveRange(at, count);
                Found(AuditFaultKind.Removed, at + 1, numberedAnew ? Numbered(chain) : chain);
            }
        }
    }

    [Fact]
    public void An_inserted_entry_is_found()
    {
        for (var at = 0; at <= 5; at++)
        {
            var chain = Chain(5);
            chain.Insert(
                at, AuditEntry.After(at == 0 ? AuditEntry.NoHash : chain[at - 1].Hash, at + 1, Start, "eve", "approved", null, "forged"));
            Found(AuditFaultKind.Inserted, at + 1, Numbered(chain));
        }
    }

    [Fact]
    public void An_inserted_entry_that_is_not_even_linked_is_found()
    {
        for (var at = 0; at < 5; at++)
        {
            var chain = Chain(5);
            chain.Insert(at, new AuditEntry(at + 1, Start, "eve", "approved", null, "forged", new string('c', 64), new string('d', 64)));
            Found(AuditFaultKind.Inserted, at + 1, Numbered(chain));
        }
    }

    [Fact]
    public void A_copy_of_an_entry_is_found()
    {
        var chain = Chain(5);
        chain.Insert(4, chain[1]);
        Found(AuditFaultKind.Inserted, 5, Numbered(chain));
        chain = Chain(5);
        chain.Add(chain[4]);
        Found(AuditFaultKind.Inserted, 6, Numbered(chain));
    }

    [Fact]
    public void Reordered_entries_are_found()
    {
        for (var at = 0; at < 4; at++)
        {
            for (var other = at + 1; other < 5; other++)
            {
                var chain = Chain(5);
                (chain[at], chain[other]) = (chain[other], chain[at]);
                Found(AuditFaultKind.Reordered, at + 1, Numbered(chain));
            }
        }
    }

    [Fact]
    public void A_trail_that_was_written_anew_is_found_by_its_seal()
    {
        var chain = new List<AuditEntry>();
        foreach (var entry in Chain(5)) chain.Add(AuditEntry.After(
            chain.Count == 0 ? AuditEntry.NoHash : chain[^1].Hash, entry.Seq, entry.At, "eve", entry.What, entry.Subject, entry.Basis));
        var forged = Head(chain) with { Seal = Head(Chain(5)).Seal };
        Assert.Null(AuditChain.Verify(chain, forged, null));
        Assert.Equal(AuditFaultKind.Unsealed, AuditChain.Verify(chain, forged, Key)?.Kind);
        Assert.Equal(AuditFaultKind.Unsealed, AuditChain.Verify(chain, forged with { Seal = null }, Key)?.Kind);
        Assert.Equal(AuditFaultKind.Unsealed, AuditChain.Verify([], new AuditHead(0, Start, AuditEntry.NoHash, null), Key)?.Kind);
    }

    [Fact]
    public void A_broken_seal_stays_broken()
    {
        var chain = Chain(5);
        var broken = Head(chain) with { Seal = new string('e', 64) };
        var next = AuditEntry.After(chain[^1].Hash, 6, Start, "anna", "approved", null, "looks right");
        Assert.False(broken.With(next, Key, begins: false).IsSealedBy(Key));
        Assert.True(Head(chain).With(next, Key, begins: false).IsSealedBy(Key));
    }

    private static void Found(AuditFaultKind kind, long seq, List<AuditEntry> chain)
    {
        var fault = AuditChain.Verify(chain, Head(Chain(5)), Key);
        Assert.Equal((kind, seq), (fault?.Kind, fault?.Seq));
    }

    private static List<AuditEntry> Numbered(List<AuditEntry> chain) => [.. chain.Select((e, i) => e with { Seq = i + 1 })];

    private static AuditHead Head(List<AuditEntry> chain) =>
        new(chain.Count, chain[^1].At, chain[^1].Hash, AuditHead.SealOf(Key, chain.Count, chain[^1].Hash));

    private static List<AuditEntry> Chain(int count)
    {
        var chain = new List<AuditEntry>();
        for (var seq = 1; seq <= count; seq++)
        {
            chain.Add(AuditEntry.After(
                chain.Count == 0 ? AuditEntry.NoHash : chain[^1].Hash,
                seq,
                Start.AddSeconds(seq),
                "anna",
                "approved",
                $"correction {seq}",
                "looks right"));
        }

        return chain;
    }
}
