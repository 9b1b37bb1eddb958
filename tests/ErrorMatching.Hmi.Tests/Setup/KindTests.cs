using Avalonia;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every kind of feature that there is can be set up, in words of both languages.</summary>
public sealed class KindTests
{
    [Fact]
    public Task Every_kind_has_an_icon_and_words_for_all_that_it_says() => Drawing.Needed().RunAsync(() =>
    {
        foreach (var language in Enum.GetValues<Language>())
        {
            var texts = Texts.Of(language);
            var keys = FeatureKinds.All.SelectMany(k => new[] { $"Kind.{k}", $"Points.Add.{k}" }
                .Concat(k.LeastPoints.Count > 1 ? k.LeastPoints.Select((_, i) => $"Points.Count.{k}.{i + 1}") : [])
                .Concat(k.Keys.SelectMany(key => key.Words.Select(w => $".{w}").Prepend("").Select(w => $"Key.{k}.{key.Name}{w}")))
                .Concat(k.Quantities.Keys.Select(q => $"Quantity.{q}"))).Concat(VerifiedQuantity.All.Select(q => $"VerifiedQuantity.{q}"));
            Assert.Empty(keys.Where(k => !texts.ContainsKey(k)).Select(k => $"{k} ({language})"));
        }

        Assert.All(
            FeatureKinds.All, k => Assert.True(Application.Current!.TryGetResource($"Icon.kind-{k}", null, out _), $"{k} has no icon."));
    });

    [Fact]
    public Task A_feature_of_every_kind_is_added_and_drawn_and_its_keys_are_set() => SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        seat.Seat.Tap("setup-anew");
        foreach (var kind in FeatureKinds.All)
        {
            seat.Seat.Tap($"add-{kind}");
        }

        seat.Settle();
        Assert.Equal(FeatureKinds.All, seat.Draft.Features.Select(f => f.Kind));
        Assert.Equal(FeatureKinds.All.Select(k => k.LeastPoints.Sum()), seat.Draft.Features.Select(f => f.Points.Count()));
        var drawing = Hmi.PartDrawing.Of(seat.Draft);
        Assert.All(
            drawing.Lines.Zip(seat.Draft.Features),
            l => Assert.Equal(l.Second.Points.Select(p => p.Label), l.First.Points.Select(p => p.Label)));

        // One beside the other, from left to right.
        Assert.All(
            drawing.Lines.Zip(drawing.Lines.Skip(1)),
            l => Assert.True(
                l.First.Outline.Max(p => p.X) < l.Second.Outline.Min(p => p.X), $"{l.Second.Name} is drawn over {l.First.Name}."));
        foreach (var (feature, index) in seat.Draft.Features.Select((f, i) => (f, i)))
        {
            foreach (var key in feature.Kind.Keys)
            {
                var text = key.Words.Count > 0 ? key.Words[^1] : "1";
                seat.Shell.Editing.Change("", d => d.WithFeature(index, f => f.With(key.Name, text)));
                Assert.Equal(text, seat.Draft.Features[index][key.Name]);
            }
        }
    });
}
