using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What can be touched is found by tests and tools under a name of its own, the same in either language.</summary>
[Trait("Length", "Long")]
public sealed class AutomationIdTests
{
    [Fact]
    public Task Whatever_is_touched_has_an_id_that_nothing_else_on_the_screen_has_in_any_language() => Seat.AtAsync(seat =>
    {
        var (problems, seen) = (new List<string>(), new HashSet<string>(StringComparer.Ordinal));
        new Tour(seat).Deliver().Around(name =>
        {
            var english = Ids(seat);
            problems.AddRange(english.Where(c => c.Id.Length == 0).Select(c => $"{name}: a {c.Type} without an id"));
            problems.AddRange(
                english.GroupBy(c => c.Id).Where(g => g.Count() > 1).Select(g => $"{name}: {g.Key} stands for {g.Count()} things"));
            seen.UnionWith(english.Select(c => c.Id));
            Texts.Current.Language = Language.TraditionalChinese;
            seat.User.Settle();
            problems.AddRange(Ids(seat).Except(english).Select(c => $"{name}: {c.Id} in Chinese only"));
            Texts.Current.Language = Language.English;
            seat.User.Settle();
        });
        Assert.True(problems.Count == 0, string.Join('\n', problems.Distinct()));
        Assert.True(seen.Count > 150, $"{seen.Count} are seen.");
    });

    private static (string Type, string Id)[] Ids(Seat seat) =>
    [
        .. seat.Window.GetVisualDescendants()
            .OfType<Control>()
            .Where(
                c => c.IsEffectivelyVisible
                    && (Layout.IsTouched(c) || c is PlotArea or ProgramText)
                    && !Layout.IsPart(c)
                    && !seat.Window.Stage.IsVisualAncestorOf(c))
            .Select(c => (c.GetType().Name, AutomationProperties.GetAutomationId(c) ?? "")),
    ];
}
