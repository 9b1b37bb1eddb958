using Avalonia.Controls;
using Avalonia.Controls.Templates;

namespace ErrorMatching.Hmi;

/// <summary>Maps view models to views. A new screen needs one line.</summary>
internal sealed class Views : IRecyclingDataTemplate
{
    private static readonly Dictionary<Type, (Type View, Func<Control> Make)> All = new()
    {
        [typeof(LoginViewModel)] = (typeof(LoginView), () => new LoginView()),
        [typeof(OverviewViewModel)] = (typeof(OverviewView), () => new OverviewView()),
        [typeof(PointsViewModel)] = (typeof(PointsView), () => new PointsView()),
        [typeof(OutlineChoice)] = (typeof(OutlineChoiceView), () => new OutlineChoiceView()),
        [typeof(FeatureEdit)] = (typeof(FeatureEditView), () => new FeatureEditView()),
        [typeof(FlankEdit)] = (typeof(FlankEditView), () => new FlankEditView()),
        [typeof(SystemViewModel)] = (typeof(SystemView), () => new SystemView()),
        [typeof(FieldRow)] = (typeof(FieldRowView), () => new FieldRowView()),
        [typeof(SideHead)] = (typeof(SideHeadView), () => new SideHeadView()),
        [typeof(BlocksRow)] = (typeof(BlocksRowView), () => new BlocksRowView()),
        [typeof(TextField)] = (typeof(TextFieldView), () => new TextFieldView()),
        [typeof(ChoiceField)] = (typeof(ChoiceFieldView), () => new ChoiceFieldView()),
        [typeof(SwitchField)] = (typeof(SwitchFieldView), () => new SwitchFieldView()),
        [typeof(NoteField)] = (typeof(NoteFieldView), () => new NoteFieldView()),
        [typeof(CompensationViewModel)] = (typeof(CompensationView), () => new CompensationView()),
        [typeof(CorrectionDetail)] = (typeof(CorrectionDetailView), () => new CorrectionDetailView()),
        [typeof(ProgramPicture)] = (typeof(ProgramPictureView), () => new ProgramPictureView()),
        [typeof(VerificationViewModel)] = (typeof(VerificationView), () => new VerificationView()),
        [typeof(PieceDetail)] = (typeof(PieceDetailView), () => new PieceDetailView()),
        [typeof(FreeformViewModel)] = (typeof(FreeformView), () => new FreeformView()),
        [typeof(SurfaceDetail)] = (typeof(SurfaceDetailView), () => new SurfaceDetailView()),
        [typeof(HistoryViewModel)] = (typeof(HistoryView), () => new HistoryView()),
        [typeof(MessagesViewModel)] = (typeof(MessagesView), () => new MessagesView()),
        [typeof(SettingsViewModel)] = (typeof(SettingsView), () => new SettingsView()),
        [typeof(UsersViewModel)] = (typeof(UsersView), () => new UsersView()),
        [typeof(ConnectionsViewModel)] = (typeof(ConnectionsView), () => new ConnectionsView()),
        [typeof(LookViewModel)] = (typeof(LookView), () => new LookView()),
        [typeof(AboutViewModel)] = (typeof(AboutView), () => new AboutView()),
        [typeof(FileChooserViewModel)] = (typeof(FileChooserView), () => new FileChooserView()),
        [typeof(LongCommand)] = (typeof(WorkingView), () => new WorkingView()),
        [typeof(SigningViewModel)] = (typeof(SigningView), () => new SigningView()),
        [typeof(LeavingViewModel)] = (typeof(LeavingView), () => new LeavingView()),
    };

    /// <summary>The view models that have a view.</summary>
    internal static IEnumerable<Type> ViewModels => All.Keys;

    /// <summary>Creates each of the views.</summary>
    internal static IEnumerable<Func<Control>> Makers => All.Values.Select(v => v.Make);

    /// <summary>True if a view model has a view.</summary>
    internal static bool Has(object viewModel) => All.ContainsKey(viewModel.GetType());

    /// <summary>Creates the view of a view model that has one.</summary>
    internal static Control Make(object viewModel) => All[viewModel.GetType()].Make();

    /// <inheritdoc/>
    public bool Match(object? data) => data is not null && Has(data);

    /// <inheritdoc/>
    public Control? Build(object? param) => Build(param, null);

    /// <summary>A view model of the same type reuses the existing view, which keeps its state.</summary>
    public Control? Build(object? data, Control? existing)
    {
        if (data is null)
        {
            return null;
        }

        var (view, make) = All[data.GetType()];
        return existing?.GetType() == view ? existing : make();
    }
}
