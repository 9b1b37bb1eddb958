using Avalonia;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The only screen of a station.</summary>
internal sealed class OneScreen(PixelSize size, double scaling) : ScreensBase<int, PlatformScreen>
{
    protected override IReadOnlyList<int> GetAllScreenKeys() => [1];

    protected override PlatformScreen CreateScreenFromKey(int key) => new Only(size, scaling);

    private sealed class Only : PlatformScreen
    {
        public Only(PixelSize size, double scaling)
            : base(new PlatformHandle(1, "screen"))
        {
            Scaling = scaling;
            Bounds = WorkingArea = new PixelRect(size);
            IsPrimary = true;
        }
    }
}
