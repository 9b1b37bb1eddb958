using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void Public_surface_is_the_one_in_the_snapshot() => PublicApi.MatchesSnapshot(typeof(Matcher).Assembly);
}
