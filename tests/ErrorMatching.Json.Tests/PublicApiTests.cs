using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Json.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void Public_surface_is_the_one_in_the_snapshot() => PublicApi.MatchesSnapshot(typeof(JsonItem).Assembly);

    [Fact]
    public void Public_surface_of_refusals_is_the_one_in_the_snapshot() => PublicApi.MatchesSnapshot(typeof(Refusal).Assembly);
}
