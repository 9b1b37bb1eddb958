using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>What somebody can do to the rows of a trail who can write the store's file, triggers or not,
/// but does not have the keys.</summary>
public sealed class AuditTrailTests : PeopleTest
{
    private const int Entries = 9;

    private AuditTrail Evidence => new(Store, Keys);

    public AuditTrailTests()
    {
        for (var i = 2; i <= Entries; i++)
        {
            Clock.Pass(TimeSpan.FromSeconds(1));
            Store.Audit("anna", "noted", $"looks right {i}", $"correction {i}");
        }
    }

    [Fact]
    public void A_trail_as_it_was_written_holds()
    {
        var finding = Evidence.Verify();
        Assert.Equal((true, Entries, true), (finding.Holds, finding.Entries, finding.IsSealChecked));
        Assert.Equal("9 entries, and all are as they were written.", finding.Message);
        Assert.Equal(Store.AuditEntries(Entries - 1, 1)[0].Hash, finding.Hash);
    }

    public static TheoryData<string, long> Fields
    {
        get
        {
            var data = new TheoryData<string, long>();
            foreach (var change in new[]
            {
                "who = 'eve'", "who = 'Anna'", "who = who || ' '", "what = 'rejected'", "subject = 'correction 99'", "subject = ''",
                "subject = NULL", "basis = ''", "basis = basis || '.'", "at = at + 1", "at = at - 1000000", "at = 0",
                "at = 9223372036854775807", "at = -9223372036854775808", "at = 'noon'", "who = ''", "hash = '" + AuditEntry.NoHash + "'",
                "hash = upper(hash)", "hash = ''", "previous = hash", "previous = ''",
                "previous = '" + AuditEntry.NoHash + "', who = 'eve'", "who = what, what = who", "subject = basis, basis = subject || ''",
                "who = x'ff'",
            })
            {
                foreach (var seq in new long[] { 2, 5, Entries })
                {
                    data.Add(change, seq);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Fields))]
    public void A_changed_field_is_found_and_its_entry_named(string change, long seq) =>
        Found(AuditFaultKind.Changed, seq, $"UPDATE audit SET {change} WHERE seq = {seq}");

    [Theory]
    [InlineData(1, 1), InlineData(2, 1), InlineData(5, 1), InlineData(4, 3), InlineData(Entries, 1), InlineData(7, 3), InlineData(1, 3),
        InlineData(1, Entries)]
    public void Removed_entries_are_found(long first, int count) =>
        Found(AuditFaultKind.Removed, first, $"DELETE FROM audit WHERE seq BETWEEN {first} AND {first + count - 1}");

    [Theory]
    [InlineData(1, 1), InlineData(5, 1), InlineData(4, 3)]
    public void Removed_entries_are_found_when_the_others_close_up(long first, int count) => Found(
        AuditFaultKind.Removed,
        first,
        $"DELETE FROM audit WHERE seq BETWEEN {first} AND {first + count - 1}",
        $"UPDATE audit SET seq = seq - {count} WHERE seq > {first}");

    [Theory]
    [InlineData(8, 1), InlineData(5, 4), InlineData(1, 8)]
    public void A_removed_end_is_found_though_the_head_says_so_too(long last, int count)
    {
        var hash = Store.AuditEntries(last - 1, 1)[0].Hash;
        Found(
            AuditFaultKind.Unsealed, last, $"DELETE FROM audit WHERE seq > {last}", $"UPDATE audit_head SET seq = {last}, hash = '{hash}'");
        Assert.Equal(Entries, last + count);
    }

    [Theory]
    [InlineData(1), InlineData(2), InlineData(5), InlineData(Entries)]
    public void An_inserted_entry_is_found(long seq)
    {
        var forged = Forged(seq, "eve");
        Found(
            AuditFaultKind.Inserted,
            seq,
            $"UPDATE audit SET seq = -seq WHERE seq >= {seq}",
            $"UPDATE audit SET seq = 1 - seq WHERE seq < 0",
            Insert(forged));
    }

    [Fact]
    public void An_entry_behind_the_end_is_found() => Found(AuditFaultKind.Inserted, Entries + 1, Insert(Forged(Entries + 1, "eve")));

    [Fact]
    public void An_entry_behind_the_end_is_found_though_the_head_says_so_too()
    {
        var forged = Forged(Entries + 1, "eve");
        Found(AuditFaultKind.Unsealed, Entries + 1, Insert(forged), $"UPDATE audit_head SET seq = {forged.Seq}, hash = '{forged.Hash}'");
    }

    [Theory]
    [InlineData(0), InlineData(-1)]
    public void An_entry_before_the_first_is_found(long seq)
    {
        Tamper(Insert(Forged(1, "eve") with { Seq = seq }));
        Assert.False(Evidence.Verify().Holds);
    }

    [Theory]
    [InlineData(1, 2), InlineData(4, 5), InlineData(2, 8), InlineData(8, Entries), InlineData(1, Entries)]
    public void Reordered_entries_are_found(long one, long other) => Found(
        AuditFaultKind.Reordered,
        one,
        $"UPDATE audit SET seq = -{one} WHERE seq = {one}",
        $"UPDATE audit SET seq = {one} WHERE seq = {other}",
        $"UPDATE audit SET seq = {other} WHERE seq = -{one}");

    [Theory]
    [InlineData(1), InlineData(5), InlineData(8)]
    public void An_entry_that_is_changed_and_hashed_again_is_found(long seq) =>
        Found(AuditFaultKind.Changed, seq, [$"UPDATE audit SET who = 'eve' WHERE seq = {seq}", .. Rehash(seq, seq)]);

    [Fact]
    public void The_last_entry_changed_and_hashed_again_is_found() =>
        Found(AuditFaultKind.Changed, Entries, [Rewritten(Entries), .. Rehash(Entries, Entries)]);

    [Theory]
    [InlineData(1), InlineData(5), InlineData(Entries)]
    public void All_that_follows_hashed_again_is_found_by_the_seal(long seq)
    {
        string[] rehash = [Rewritten(seq), .. Rehash(seq, Entries)];
        Found(AuditFaultKind.Changed, Entries, rehash);
        Found(AuditFaultKind.Unsealed, Entries, "UPDATE audit_head SET hash = (SELECT hash FROM audit ORDER BY seq DESC LIMIT 1)");
        Found(AuditFaultKind.Unsealed, Entries, "UPDATE audit_head SET seal = NULL");
        Found(AuditFaultKind.Unsealed, Entries, "UPDATE audit_head SET seal = hash");
    }

    [Fact]
    public void A_trail_hashed_again_and_sealed_with_other_keys_is_found()
    {
        Tamper([Rewritten(3), .. Rehash(3, Entries)]);
        var hash = Store.AuditEntries(Entries - 1, 1)[0].Hash;
        Found(
            AuditFaultKind.Unsealed,
            Entries,
            $"UPDATE audit_head SET hash = '{hash}', seal = '{AuditHead.SealOf(AuditKey.Open(PathOf("others")), Entries, hash)}'");
    }

    [Theory]
    [InlineData("seq = seq - 1", AuditFaultKind.Inserted, Entries), InlineData("seq = seq + 1", AuditFaultKind.Removed, Entries + 1),
        InlineData("hash = seal", AuditFaultKind.Changed, Entries), InlineData("seal = NULL", AuditFaultKind.Unsealed, Entries)]
    [InlineData("seal = hash", AuditFaultKind.Unsealed, Entries), InlineData("seal = upper(seal)", AuditFaultKind.Unsealed, Entries)]
    public void A_changed_head_is_found(string change, AuditFaultKind kind, long seq) =>
        Found(kind, seq, $"UPDATE audit_head SET {change}");

    [Fact]
    public void A_lost_head_is_named()
    {
        Tamper("DELETE FROM audit_head");
        Assert.Equal(StoreError.Damaged, Assert.Throws<StoreException>(() => Evidence.Verify()).Error);
    }

    [Fact]
    public void The_next_entry_does_not_heal_what_was_broken()
    {
        Tamper(
            $"DELETE FROM audit WHERE seq = {Entries}",
            $"UPDATE audit_head SET seq = {Entries - 1}, hash = '{Store.AuditEntries(Entries - 2, 1)[0].Hash}'");
        Store.Audit("anna", "noted", "as if nothing were");
        Assert.Equal(AuditFaultKind.Unsealed, Evidence.Verify().Fault?.Kind);
    }

    [Theory]
    [InlineData(true), InlineData(false)]
    public void An_older_end_that_was_once_sealed_is_found_if_somebody_looked_since(bool isVerified)
    {
        var old = Store.AuditHead();
        Store.Audit("anna", "noted", "to be forgotten");
        Store.Audit("anna", "noted", "this too");
        if (isVerified)
        {
            Assert.True(Evidence.Verify().Holds);
        }
        else
        {
            Evidence.Remember();
        }

        Found(
            AuditFaultKind.Removed,
            Entries + 1,
            $"DELETE FROM audit WHERE seq > {Entries}",
            $"UPDATE audit_head SET seq = {old.Seq}, at = 0, hash = '{old.Hash}', seal = '{old.Seal}'");
        Assert.Contains("Entries 10 to 11 are missing", Evidence.Verify().Message, StringComparison.Ordinal);

        // Other entries in their place do not hide it, and looking at the end does not forget it.
        Store.Audit("eve", "noted", "instead");
        Store.Audit("eve", "noted", "instead");
        Evidence.Remember();
        Found(AuditFaultKind.Changed, Entries + 2);
        Store.Audit("eve", "noted", "and more");
        Evidence.Remember();
        Found(AuditFaultKind.Changed, Entries + 2);
    }

    [Fact]
    public void An_older_store_in_the_place_of_the_present_one_is_found()
    {
        Store.Backup(PathOf("older.db"));
        Store.Audit("anna", "noted", "to be forgotten");
        Assert.True(Evidence.Verify().Holds);
        using var older = CellStore.Open(new SqliteSettings(PathOf("older.db")), Clock, Key);
        Assert.Equal(
            (AuditFaultKind.Removed, Entries + 1L), new AuditTrail(older, Keys).Verify().Fault is { } f ? (f.Kind, f.Seq) : default);
    }

    [Fact]
    public void A_backup_that_is_brought_back_on_purpose_puts_the_gap_on_record()
    {
        Store.Backup(PathOf("older.db"));
        Store.Audit("anna", "noted", "to be forgotten");
        var lost = Evidence.Verify();
        using var older = CellStore.Open(new SqliteSettings(PathOf("older.db")), Clock, Key);
        var evidence = new AuditTrail(older, Keys);
        evidence.TakeOver("console", "A backup was brought back.");
        var entry = older.AuditEntries(Entries, 10)[^1];
        Assert.Equal(
            ("console", "trail-set-back", $"set-back(A backup was brought back., 10, {lost.Hash})"),
            (entry.Who, entry.What, Stated.As(entry.Basis)));
        Assert.Equal((true, Entries + 1), (evidence.Verify().Holds, evidence.Verify().Entries));

        // Once is enough, and what goes on is no gap.
        evidence.TakeOver("console", "A backup was brought back.");
        Assert.Equal(Entries + 1, evidence.Verify().Entries);
    }

    [Fact]
    public void Nobody_takes_over_what_was_not_sealed()
    {
        Evidence.Remember();
        Tamper(
            $"DELETE FROM audit WHERE seq = {Entries}",
            $"UPDATE audit_head SET seq = {Entries - 1}, hash = '{Store.AuditEntries(Entries - 2, 1)[0].Hash}'");
        Evidence.TakeOver("eve", "nothing to see");
        Assert.Equal(AuditFaultKind.Unsealed, Evidence.Verify().Fault?.Kind);
        Assert.DoesNotContain(Trail, e => e.StartsWith("eve", StringComparison.Ordinal));
    }

    [Fact]
    public void An_emptied_trail_is_found()
    {
        Evidence.Remember();
        Found(AuditFaultKind.Removed, 1, "DELETE FROM audit");
        Found(AuditFaultKind.Unsealed, 0, $"UPDATE audit_head SET seq = 0, hash = '{AuditEntry.NoHash}', seal = NULL");
    }

    [Fact]
    public void Without_the_keys_nothing_is_proved()
    {
        var without = new AuditTrail(Store, PathOf("none"));
        var finding = without.Verify();
        Assert.Equal((AuditFaultKind.KeysMissing, false), (finding.Fault?.Kind, finding.IsSealChecked));
        Assert.Contains("cannot be said", finding.Message, StringComparison.Ordinal);
        Assert.False(Directory.Exists(PathOf("none")));
        Tamper("UPDATE audit SET who = 'eve' WHERE seq = 5");
        Assert.Equal(5, without.Verify().Fault?.Seq);
    }

    [Fact]
    public void Keys_of_another_cell_do_not_fit() => Assert.Equal(AuditFaultKind.Unsealed, OfOthers().Verify().Fault?.Kind);

    [Fact]
    public void A_witness_that_says_nothing_is_named()
    {
        Evidence.Remember();
        File.WriteAllText(Path.Combine(Keys, "audit.seen"), "nine\n");
        Assert.Contains("audit.seen", Refused(PeopleError.KeysUnusable, () => Evidence.Verify()).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_export_has_every_entry_and_its_hash()
    {
        Store.Audit("=cmd|' /C calc'!A0", "@SUM(A1)", "-1;=1\r\n+1 \"ok\"", "\t=1");
        using var csv = new StringWriter();
        Assert.Equal(Entries + 1, Evidence.Export(csv));
        var lines = csv.ToString().Split("\"\r\n\"");
        Assert.Equal(
            "\"number\",\"time\",\"who\",\"what\",\"subject\",\"basis\",\"previous\",\"hash\",\"rows\",\"subjectRecorded\","
                + "\"basisRecorded",
            lines[0]);
        var second = Store.AuditEntries(1, 1)[0];
        Assert.Equal($"2\",\"2026-03-01T06:00:01.000000Z\",\"anna\",\"noted\",\"correction 2\",\"looks right "
            + $"2\",\"{second.Previous}\",\"{second.Hash}\",\"\",\"correction 2\",\"looks right 2", lines[2]);
        Assert.Contains(
            "\"'=cmd|' /C calc'!A0\",\"'@SUM(A1)\",\"'\t'=1\",\"'-1;'=1\r\n'+1 \"\"ok\"\"\"", csv.ToString(), StringComparison.Ordinal);
        Store.Audit("cell", "freed", "=1", Recorded.Slot.With("=1", "mill"));
        using var more = new StringWriter();
        Evidence.Export(more);
        Assert.Contains("\"freed\",\"slot =1 of mill\",\"'=1\",", more.ToString(), StringComparison.Ordinal);
        Assert.EndsWith("\"\u001e[\"\"slot\"\",\"\"=1\"\",\"\"mill\"\"]\",\"'=1\"\r\n", more.ToString(), StringComparison.Ordinal);
    }

    private AuditTrail OfOthers()
    {
        AuditKey.Open(PathOf("others"));
        return new AuditTrail(Store, PathOf("others"));
    }

    private void Found(AuditFaultKind kind, long seq, params string[] tampering)
    {
        Tamper(tampering);
        var finding = Evidence.Verify();
        Assert.Equal((kind, seq), finding.Fault is { } fault ? (fault.Kind, fault.Seq) : default);
        Assert.Contains(seq.ToString(CultureInfo.InvariantCulture), finding.Message, StringComparison.Ordinal);
    }

    // As with the command line of SQLite: nothing of the cell is asked, no entry is appended.
    private void Tamper(params string[] statements)
    {
        foreach (var statement in statements.Prepend("DROP TRIGGER IF EXISTS audit_update; DROP TRIGGER IF EXISTS audit_delete"))
        {
            Store.Database.Change((connection, transaction) =>
            {
                using var command = connection.CreateCommand();
                command.Transaction = transaction;
                command.CommandText = statement;
                return command.ExecuteNonQuery();
            });
        }
    }

    private AuditEntry Forged(long seq, string who) =>
        AuditEntry.After(seq == 1 ? AuditEntry.NoHash : Store.AuditEntries(seq - 2, 1)[0].Hash, seq, Clock.Now, who, "noted",
            "correction 99", "forged");

    private static string Rewritten(long from) => $"UPDATE audit SET who = 'eve' WHERE seq >= {from}";

    private static string Insert(AuditEntry e) => string.Create(
        CultureInfo.InvariantCulture,
        $"INSERT INTO audit (seq, at, who, what, subject, basis, previous, hash) VALUES ({e.Seq}, {StoredTime.Of(e.At)}, '{e.Who}', "
            + $"'{e.What}', '{e.Subject?.Text}', '{e.Basis.Text}', '{e.Previous}', '{e.Hash}')");

    // The chain from one entry to another as eve would have written it, by the published form alone.
    private IEnumerable<string> Rehash(long first, long last)
    {
        var previous = first == 1 ? AuditEntry.NoHash : Store.AuditEntries(first - 2, 1)[0].Hash;
        foreach (var e in Store.AuditEntries(first - 1, (int)(last - first + 1)))
        {
            using var form = new MemoryStream();
            form.Write("errormatch audit 1"u8);
            Number(form, e.Seq, 8);
            Number(form, StoredTime.Of(e.At), 8);
            foreach (var text in new[] { previous, "eve", e.What, e.Subject?.Text, e.Basis.Text })
            {
                Number(form, text is null ? -1 : Encoding.UTF8.GetByteCount(text), 4);
                form.Write(Encoding.UTF8.GetBytes(text ?? ""));
            }

            var hash = Convert.ToHexStringLower(SHA256.HashData(form.ToArray()));
            yield return $"UPDATE audit SET previous = '{previous}', hash = '{hash}' WHERE seq = {e.Seq}";
            previous = hash;
        }
    }

    private static void Number(MemoryStream form, long number, int bytes)
    {
        for (var i = bytes - 1; i >= 0; i--)
        {
            form.WriteByte((byte)(number >> (8 * i)));
        }
    }
}
