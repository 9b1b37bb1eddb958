using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Refusals that are shown in another language: they carry the values of their sentence, exactly.</summary>
public sealed class RefusalFormsTests
{
    [Fact]
    public void A_refusal_states_its_code_and_its_exact_values()
    {
        var refusal = RefusalForms.Refusal(RefusalForms.ImplausibleDeviation, InputPlace.None, "5", "C1", 2.56612345, 1.0);
        Assert.Equal(["5", "C1", "2.56612345", "1"], refusal.Values);
        Assert.Equal(refusal.Message, RefusalForms.StatementOf(refusal).Sentence);
    }

    [Fact]
    public void Refusals_and_warnings_have_their_sentences() => SentenceList.Matches(
        RefusalForms.All.Concat(WarningForms.All).Select(f => (f.Name, f.Template)),
        "ErrorMatching.Mating.Tests",
        "Deciding",
        "sentences.txt");

    [Fact]
    public void Every_form_is_stated_again_from_the_values_of_its_refusal() => Assert.All(RefusalForms.All, form =>
    {
        var refusal = RefusalForms.Refusal(form, InputPlace.None, [.. form.Kinds.Select((k, i) => k.Length > 0 ? (object)(i + 0.5) : "x")]);
        var statement = RefusalForms.StatementOf(refusal);
        Assert.Same(form, statement.Form);
        Assert.Equal((refusal.Code, refusal.Message), (statement.Code, statement.Sentence));
    });

    [Fact]
    public void A_refusal_without_a_form_or_its_values_is_its_message()
    {
        Assert.Equal("Not so.", RefusalForms.StatementOf(new("not-so", "Not so.")).Words);
        Assert.Equal("Not so.", RefusalForms.StatementOf(new(RefusalForms.UnitDiffers.Name, "Not so.")).Words);
    }
}
