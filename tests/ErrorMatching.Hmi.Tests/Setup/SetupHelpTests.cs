using Avalonia.Controls;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What helps whoever sets up a job beside telling mistakes:
/// questions, one tap for all features, words for what holds while a field is empty.</summary>
public sealed class SetupHelpTests
{
    [Fact]
    public Task A_limit_in_micrometers_is_asked_about_at_its_field_and_not_saved() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Seat.Tap("side-tolerances").Type("edit-features[1].toleranceMm[1]", "50");
        seat.Settle();
        Assert.Equal(
            "Each limit must be at most 1\u00a0mm: the job stops there. Is it in µm?", seat.TextOf("problem-features[1].toleranceMm[1]"));
        Assert.Contains("wrong", seat.Seat.See("edit-features[1].toleranceMm[1]").Classes);
        Assert.Contains(seat.Shell.Editing.Problems, p => p.Code == "limit-implausible");
    });

    [Fact]
    public Task The_limits_of_the_first_feature_are_given_to_all_and_taken_back_in_one_step() =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Seat.Tap("side-tolerances").Type("edit-features[0].toleranceMm[0]", "-0.01").Type("edit-features[0].toleranceMm[1]", "0.02");
        seat.Seat.Tap("limits-same");
        Assert.All(seat.Draft.Features, f => Assert.Equal(("-0.01", "0.02"), (f.Lower, f.Upper)));
        Assert.Equal("0.02", ((TextBox)seat.Seat.See("edit-features[2].toleranceMm[1]")).Text);
        seat.Seat.Tap("setup-undo");
        Assert.Equal([("-0.01", "0.02"), ("-0.05", "0.05"), ("-0.05", "0.05")], seat.Draft.Features.Select(f => (f.Lower, f.Upper)));
    });

    [Fact]
    public Task What_holds_while_a_field_is_empty_is_said_in_the_language_of_the_screen() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Shell.Editing.Change("", d => d.WithFeature(2, f => f.With("degree", "").With("ridge", "")));
        seat.Settle();
        var (degree, tolerances) = ("edit-features[2].degree", "side-tolerances");
        Assert.Equal("empty: automatic", ((TextBox)seat.Seat.Tap(tolerances).See(degree)).PlaceholderText);
        Texts.Current.Language = Language.TraditionalChinese;
        seat.Settle();
        Assert.Equal("預設 自動", ((TextBox)seat.Seat.See(degree)).PlaceholderText);
    });
}
