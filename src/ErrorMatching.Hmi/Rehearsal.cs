using System.Text;
using Avalonia.Controls;
using Avalonia.Threading;
using ErrorMatching.Nc;

namespace ErrorMatching.Hmi;

/// <summary>Opens every screen once, invisibly, while the user is idle. The first execution of code takes two or three times as
/// long as later ones; this way the user does not wait for it.</summary>
/// <param name="window">The window. Its stage is the panel to open them in, one at a time; it is empty before and after.</param>
/// <param name="shell">The shell that the screens belong to. Opening a screen only reads. The only lasting effect is that the
/// first job is loaded into the set-up, as when a user opens that screen first.</param>
public sealed class Rehearsal(MainWindow window, ShellViewModel shell)
{
    // Every control of a panel is a step of its own.
    private const int Each = 0;

    // Time for background reading to finish.
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(150);
    private static readonly byte[] Program = Encoding.ASCII.GetBytes(
        "N10 G21 G90\nN20 G0 X0. Y0. Z5.\nN30 G1 Z0. F500.\nN40 G2 X10. Y10. I5. J5.\nM30\n");

    private readonly Stage _stage = (window ?? throw new ArgumentNullException(nameof(window))).Stage;

    /// <summary>Opens them all in small steps; keys, taps and drawing have priority.</summary>
    public async Task RunAsync(CancellationToken end)
    {
        try
        {
            // First each view alone, or creating the first screen would be one long step.
            foreach (var make in Views.Makers)
            {
                await ShowAsync(make, end);
            }

            foreach (var screen in Screens.All)
            {
                await OpenAsync(screen, end);
            }

            var program = await Task.Run(() => OpenedProgram.Read(Program, NcDialects.FanucMill, end), end);
            await UnfoldAsync(() => new ProgramPicture(program), TimeSpan.Zero, end);
        }
        finally
        {
            _stage.Children.Clear();
        }
    }

    private static Task StepAsync(Action step, CancellationToken end) =>
        Dispatcher.UIThread.InvokeAsync(step, DispatcherPriority.SystemIdle, end).GetTask();

    private static Control ViewOf(object content)
    {
        var view = Views.Make(content);
        view.DataContext = content;
        return view;
    }

    private async Task OpenAsync(Screen screen, CancellationToken end)
    {
        ScreenViewModel? opened = null;
        try
        {
            await UnfoldAsync(() => opened = screen.Open(shell), Look, end);
        }
        finally
        {
            _stage.Children.Clear();
            opened?.Dispose();
        }
    }

    // Create, attach and lay out in separate steps, because each is slow.
    private async Task ShowAsync(Func<Control> make, CancellationToken end)
    {
        Control? made = null;
        await StepAsync(_stage.Children.Clear, end);
        await StepAsync(MainWindow.Tidy, end);
        await StepAsync(() => made = make(), end);
        await StepAsync(() => _stage.Children.Add(made!), end);
        await StepAsync(_stage.UpdateLayout, end);
    }

    // Showing a whole screen in one step would take too long; its parts appear one by one.
    private async Task UnfoldAsync(Func<object> open, TimeSpan look, CancellationToken end)
    {
        object? content = null;
        Unfolding? unfolding = null;
        await StepAsync(() => content = open(), end);
        await ShowAsync(
            () =>
            {
                var view = ViewOf(content!);
                unfolding = new(view, Each);
                return view;
            },
            end);
        await Task.Delay(look, end);
        await UnfoldAsync(unfolding!, end);

        // By now, rows that are loaded later have arrived.
        await StepAsync(_stage.UpdateLayout, end);
    }

    private static async Task UnfoldAsync(Unfolding unfolding, CancellationToken end)
    {
        while (unfolding.Coming is { } part)
        {
            Unfolding? within = null;
            if (part is ContentControl { Content: { } content } host && Views.Has(content))
            {
                Control? view = null;
                await StepAsync(() => view = ViewOf(content), end);
                await StepAsync(
                    () =>
                    {
                        within = new(view!, Each);
                        host.Content = view;
                    },
                    end);
            }

            await StepAsync(unfolding.Next, end);
            if (within is not null)
            {
                await UnfoldAsync(within, end);
            }
        }
    }
}
