using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Hmi.Testing;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A person in front of a station at a cell of their own:
/// finds what is on the screen by its AutomationId, taps, types, waits.</summary>
internal sealed class Seat : IAsyncDisposable
{
    /// <summary>Generous: a test waits for the event and not for the clock.</summary>
    public static readonly TimeSpan Patience = TimeSpan.FromSeconds(60);

    // A station without a connection sees nothing new, however long one waits.
    private static readonly TimeSpan CatchUp = TimeSpan.FromSeconds(3);

    // Made once for all tests of a process.
    private static readonly Lazy<string> Template = new(() =>
    {
        var folder = new TemporaryFolder();
        AppDomain.CurrentDomain.ProcessExit += (_, _) => folder.Dispose();
        var settings = DemoCell.Make(folder.Path, TimeProvider.System).Settings;
        // Its gauges' files come whole: nobody has to wait until they rest.
        var file = Path.Combine(folder.Path, "cell", "cell.json");
        File.WriteAllText(
            file,
            File.ReadAllText(file)
                .Replace("\"atRestS\": 0.5", "\"atRestS\": 0.05", StringComparison.Ordinal)
                .Replace("\"everyMs\": 100", "\"everyMs\": 20", StringComparison.Ordinal));
        return folder.Path;
    });

    private readonly TemporaryFolder _folder = new();

    private Seat(SeatClock clock, TimeSpan idle, Size size, Action<string>? prepare, bool hasSamples)
    {
        Clock = clock;
        Copy(Template.Value, _folder.Path);
        prepare?.Invoke(_folder.Path);
        Cell = DemoCell.At(_folder.Path, TimeProvider.System);
        Station = new(Cell.Settings, clock, idle)
        {
            Preferences = new(Path.Combine(_folder.Path, "preferences")),
            SamplesFolder = hasSamples ? Cell.SamplesFolder : null
        };
        Shell = Screens.ShellOf(Station);
        Window = new() { DataContext = Shell, Width = size.Width, Height = size.Height };
        Window.Show();
        User = new ScreenUser(Window).Settle();
    }

    public SeatClock Clock { get; }

    public DemoCell Cell { get; }

    public Station Station { get; }

    public ShellViewModel Shell { get; }

    public MainWindow Window { get; }

    public ScreenUser User { get; }

    /// <summary>Does a test at a seat, on the screen's thread.</summary>
    /// <param name="test">The test.</param>
    /// <param name="size">The window's size; the smallest if null.</param>
    /// <param name="idle">After how long the station locks.</param>
    /// <param name="prepare">Does something to the cell's folder before it is opened.</param>
    /// <param name="hasSamples">True for a demonstration's place for the samples.</param>
    public static Task AtAsync(
        Func<Seat, Task> test, Size? size = null, TimeSpan? idle = null, Action<string>? prepare = null, bool hasSamples = false) =>
        Drawing.Needed().RunAsync(async () =>
    {
        Texts.Current.Language = Language.English;
        await using var seat = new Seat(new SeatClock(), idle ?? Station.DefaultIdle, size ?? new(1280, 800), prepare, hasSamples);
        FailedBindings.Seen.Take();
        await test(seat);
        Assert.Empty(FailedBindings.Seen.Take());
    });

    /// <summary>Does a test at a seat, on the screen's thread.</summary>
    public static Task AtAsync(
        Action<Seat> test, Size? size = null, TimeSpan? idle = null, Action<string>? prepare = null, bool hasSamples = false) =>
        AtAsync(
        seat =>
        {
            test(seat);
            return Task.CompletedTask;
        },
        size,
        idle,
        prepare,
        hasSamples);

    /// <summary>What is on the screen by that AutomationId; null if nothing is, or it is hidden,
    /// or rehearsed where nobody sees it.</summary>
    public Control? Find(string id) => Window.GetVisualDescendants().OfType<Control>()
        .FirstOrDefault(
            c => c.IsEffectivelyVisible && AutomationProperties.GetAutomationId(c) == id && !Window.Stage.IsVisualAncestorOf(c));

    /// <summary>What is on the screen by that AutomationId, waited for; where a file is chosen, until its folder is shown.</summary>
    public Control See(string id)
    {
        WaitFor(() => Find(id) is not null && Shell.Choosing is not { Loading.IsCompleted: false }, $"{id} does not appear.");
        return Find(id)!;
    }

    /// <summary>The text that stands under an AutomationId.</summary>
    public string? TextOf(string id) => (See(id) as TextBlock)?.Text;

    /// <summary>Taps with the pointer, where something is: what follows the cell may be made anew meanwhile,
    /// and then the new one is tapped, as by a person.</summary>
    public Seat Tap(string id)
    {
        See(id);
        WaitFor(() => Find(id) is { IsEffectivelyEnabled: true }, $"{id} stays disabled.");
        Find(id)?.BringIntoView();
        User.Settle();
        Point? place = null;
        WaitFor(
            () => (
                place = Find(id) is { } control ? control.TranslatePoint(new Rect(control.Bounds.Size).Center, Window) : null) is not null,
            $"{id} is gone.");
        if (Window.Aim.IsMissed(Window.InputHitTest(place!.Value), place.Value))
        {
            // Where rows have just moved, a person looks again.
            Clock.Advance(AimKeeper.OnItsWay);
        }

        User.Click(Window, place.Value);
        return this;
    }

    /// <summary>Taps into a field and types, in place of what is there.</summary>
    public Seat Type(string id, string text)
    {
        User.Click(See(id))
            .Press(Avalonia.Input.Key.A, Avalonia.Input.RawInputModifiers.Control)
            .Press(Avalonia.Input.Key.Delete)
            .Type(text);
        return this;
    }

    /// <summary>Signs in: by the user's tile, or by the name where a small screen has no room for the tile.</summary>
    public Seat SignIn(string name)
    {
        See("login-users");
        (Find("login-user-" + name) is null ? Type("login-name", name) : Tap("login-user-" + name))
            .Type("login-password", DemoCell.Password).Tap("login-sign-in");
        return WaitFor(() => !Shell.IsLocked, "The station stays locked.");
    }

    /// <summary>Saves the job that is edited, with a signature.</summary>
    public Seat Save() => Tap("setup-save").Type("signing-password", DemoCell.Password).Tap("signing-confirm");

    /// <summary>Lets the cell run, and waits until that is seen: nothing is said of a cell that stands.</summary>
    public Seat RunCell()
    {
        Cell.Run();
        return WaitFor(() => Shell.Banner is null && Station.State.Status is { IsRunning: true }, "The cell is not seen to run.");
    }

    /// <summary>Waits until something is so.</summary>
    public Seat WaitFor(Func<bool> condition, string complaint)
    {
        try
        {
            User.WaitFor(condition, Patience);
        }
        catch (TimeoutException e)
        {
            var shown = string.Join(
                " | ", Window.GetVisualDescendants().OfType<TextBlock>().Where(t => t.IsEffectivelyVisible).Select(t => t.Text));
            throw new TimeoutException($"{complaint} Shown: {shown}", e);
        }

        return this;
    }

    /// <summary>Waits until a correction has come so far, and the station has seen it: what it shows is always a little older.</summary>
    public Correction WaitFor(long id, CorrectionState state)
    {
        WaitFor(() => Station.Store.Find(id)?.State == state, $"Correction {id} does not become {state}.");
        var since = System.Diagnostics.Stopwatch.StartNew();
        WaitFor(() => IsSeen() || since.Elapsed > CatchUp, "");
        return Station.Store.Find(id)!;
    }

    private bool IsSeen() => Station.State.Status is not { } seen
        || CellStatus.Of(Station.Settings, Station.Store, Clock).Counts.All(c => seen.CountOf(c.Key) == c.Value);

    public async ValueTask DisposeAsync()
    {
        Window.Close();
        Texts.Current.Language = Language.English;
        User.Settle();
        Shell.Dispose();
        Station.Dispose();
        await Cell.DisposeAsync();
        _folder.Dispose();
    }

    private static void Copy(string from, string to)
    {
        Directory.CreateDirectory(to);
        foreach (var file in Directory.EnumerateFiles(from))
        {
            var copy = Path.Combine(to, Path.GetFileName(file));
            File.Copy(file, copy);
            if (!OperatingSystem.IsWindows())
            {
                // A key that others can read is refused.
                File.SetUnixFileMode(copy, File.GetUnixFileMode(file));
            }
        }

        foreach (var folder in Directory.EnumerateDirectories(from))
        {
            var copy = Path.Combine(to, Path.GetFileName(folder));
            Copy(folder, copy);
            if (!OperatingSystem.IsWindows())
            {
                File.SetUnixFileMode(copy, File.GetUnixFileMode(folder));
            }
        }
    }
}
