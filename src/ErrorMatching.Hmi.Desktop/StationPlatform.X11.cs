using Avalonia;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Desktop;

internal static partial class StationPlatform
{
    static partial void UseX11(ref AppBuilder builder, double scaling, Action<string> tell) => builder = builder.UseX11(scaling, tell);
}
