using ErrorMatching.Reporting;

namespace ErrorMatching.Cell.Tests;

/// <summary>What the store keeps of statements, and of words that look like them.</summary>
public sealed class RecordedStatementTests : PeopleTest
{
    private const string Lookalike = "\u001e[\"policy\"]";

    [Fact]
    public void The_store_keeps_codes_and_values_and_gives_them_back()
    {
        var unknown = Recorded.UnknownPiece.With("a.csv", "cmm", Recorded.AskedNobody.With());
        var correction = Step(Arrived(), CorrectionState.Refused, "cell", unknown);
        var basis = Store.Corrections.StepsOf(correction.Id)[^1].Basis;
        Assert.Same(Recorded.UnknownPiece, basis.Form);
        Assert.Equal("\u001e[\"unknown-piece\",\"a.csv\",\"cmm\",[\"asked-nobody\"]]", basis.Text);
        Assert.Equal(basis, Store.Find(correction.Id)!.Reason);
        var entry = Store.AuditEntries(0, 100)[^1];
        Assert.Equal((basis, "correction 1"), (entry.Basis, entry.Subject!.Sentence));
        Assert.True(Verify().Holds, Verify().Message);
    }

    [Fact]
    public void Every_form_is_kept_and_read_as_itself() => Assert.All(Recorded.All, form =>
    {
        var statement = form.With([.. form.Kinds.Select((_, i) => $"value {i}")]);
        Store.Audit("cell", "noted", statement, statement);
        var entry = Store.AuditEntries(Store.ChangeCount() - 1, 1)[0];
        Assert.Same(form, entry.Basis.Form);
        Assert.Equal((statement, statement), (entry.Subject, entry.Basis));
    });

    [Fact]
    public void What_a_person_writes_stays_words_whatever_it_looks_like()
    {
        var correction = Step(Arrived(), CorrectionState.Refused, "Sam", Lookalike);
        Assert.Equal(Lookalike, Store.Corrections.StepsOf(correction.Id)[^1].Basis.Words);
        Assert.Equal(Lookalike, Store.Find(correction.Id)!.Reason!.Words);
        Store.Audit("Sam", "noted", Lookalike, Lookalike);
        var entry = Store.AuditEntries(0, 100)[^1];
        Assert.Equal((Lookalike, Lookalike), (entry.Subject!.Words, entry.Basis.Words));
        Assert.True(Verify().Holds, Verify().Message);
    }

    [Fact]
    public void Words_that_look_like_the_policy_approve_nothing()
    {
        Anna();
        var approved = Step(Proposed(), CorrectionState.Approved, "cell", Lookalike);
        Assert.Contains(
            "who-not-by-policy",
            Stated.As(Assert.Throws<StoreException>(() => Store.Outside.DemandRecorded(approved)).Statement),
            StringComparison.Ordinal);
        Assert.Equal(AuditFaultKind.NotAllowed, Verify().Fault?.Kind);
    }

    [Fact]
    public void The_policy_approves_by_its_code()
    {
        var approved = Step(Proposed(), CorrectionState.Approved, "cell", Recorded.Policy.With());
        Store.Outside.DemandRecorded(approved);
        Assert.True(Verify().Holds, Verify().Message);
    }

    [Fact]
    public void A_statement_that_is_too_long_is_cut_in_its_values_and_stays_one()
    {
        var correction = Step(Arrived(), CorrectionState.Refused, "cell", Recorded.NotComparable.With(new string('x', 20_000)));
        var basis = Store.Corrections.StepsOf(correction.Id)[^1].Basis;
        Assert.Same(Recorded.NotComparable, basis.Form);
        Assert.InRange(basis.Text.Length, 3000, 8000);
        Store.Audit("cell", "noted", "", Recorded.Slot.With(new string('"', 2000), "mill"));
        var subject = Store.AuditEntries(0, 100)[^1].Subject!;
        Assert.Same(Recorded.Slot, subject.Form);
        Assert.InRange(subject.Text.Length, 300, 800);
        Assert.True(Verify().Holds, Verify().Message);
    }

    private AuditFinding Verify() => new AuditTrail(Store, Keys).Verify();

    private Correction Arrived() => Store.Archive(new Arrival("gauge", "one.csv", "one", "one"u8.ToArray())).Correction;

    private Correction Proposed()
    {
        var recognized = Store.Step(Arrived(), CorrectionState.Recognized, "cell", Recorded.Of.With("part", "job"), c => c with
        {
            Job = "job",
            Piece = "part",
            Identity = "one",
            Machine = "mill",
            Slot = "1",
            Program = "O1.nc",
        });
        var sha256 = Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData("program"u8));
        var computed = Store.Step(
            recognized, CorrectionState.Computed, "cell", Recorded.DisplacedNothing.With(), c => c with { ProgramSha256 = sha256 },
            ["program"u8.ToArray()]);
        return Store.Step(computed, CorrectionState.Proposed, "cell", Recorded.Computed.With());
    }

    private Correction Step(Correction from, CorrectionState to, string by, Statement reason) =>
        Store.Step(from, to, by, reason, c => c with { Reason = reason });
}
