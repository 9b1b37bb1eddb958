using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Asks for a drawing and a program, and shows how the outline lies on what the program cuts.</summary>
internal sealed class OutlineTaking
{
    private readonly PointsViewModel _screen;
    private readonly ShellViewModel _shell;
    private OutlineChoice? _choice;

    /// <summary>Asks for nothing yet.</summary>
    /// <param name="screen">The screen that tells the result.</param>
    /// <param name="shell">Lets the user choose files.</param>
    public OutlineTaking(PointsViewModel screen, ShellViewModel shell)
    {
        (_screen, _shell) = (screen, shell);
        FromDrawing = new(FromDrawingAsync, () => screen.Editing.CanEdit);
    }

    /// <summary>Raised when there is another <see cref="Choice"/>.</summary>
    public event Action? Shown;

    /// <summary>The outline that is looked at; null while none is.</summary>
    public OutlineChoice? Choice
    {
        get => _choice;
        private set
        {
            _choice = value;
            Shown?.Invoke();
        }
    }

    /// <summary>Makes features, blocks, frame and tool of the job from a drawing and a program.</summary>
    public LongCommand FromDrawing { get; }

    private async Task FromDrawingAsync(CancellationToken cancellation)
    {
        if (await FromDrawing.AskAsync(() => _shell.ChooseAsync(
                new(FileChoiceKind.Open, "Outline.ChooseDrawing", [".dxf", ".stp", ".step"]) { Sample = DemoCell.OutlineFile }))
                is not { } drawing
            || await FromDrawing.AskAsync(() => _shell.ChooseAsync(FileChoice.OfProgram(DemoCell.OutlineProgramFile)))
                is not { } program)
        {
            return;
        }

        var (editing, draft, file) = (_screen.Editing, _screen.Editing.Draft, _screen.Editing.Job!.File);
        Choice = null;
        OutlineRequest? request = null;
        Outcome<OutlineLayer[]>? layers = null;
        OpenedProgram? opened = null;
        await _screen.TryAsync(() =>
        {
            request = OutlineRequest.For(draft, file, drawing, program);
            layers = OutlineJob.LayersOf(request, cancellation);
            opened = OpenedProgram.Read(InputFile.Program(program), request.Control!, cancellation);
        });
        if (layers is { Refusal: { } refusal })
        {
            _screen.Report(() => CodeText.Of(refusal));
        }
        else if (!ReferenceEquals(draft, editing.Draft))
        {
            _screen.Report(() => Texts.Current["Outline.JobChanged"]);
        }
        else if (opened is not null)
        {
            Choice = new(editing, request!, opened, layers!.Result!, _screen.Station.Clock, () => Choice = null);
        }

        _screen.Show();
    }
}
