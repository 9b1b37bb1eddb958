using Avalonia.Controls;
using Avalonia.Controls.Templates;

namespace ErrorMatching.Hmi;

/// <summary>Which view shows which view model. A new screen takes one line.</summary>
public sealed class Views : IDataTemplate
{
    private static readonly Dictionary<Type, Func<Control>> All = new()
    {
        [typeof(LoginViewModel)] = () => new LoginView(),
        [typeof(OverviewViewModel)] = () => new OverviewView(),
        [typeof(CompensationViewModel)] = () => new CompensationView(),
        [typeof(CorrectionDetail)] = () => new CorrectionDetailView(),
        [typeof(HistoryViewModel)] = () => new HistoryView(),
        [typeof(MessagesViewModel)] = () => new MessagesView(),
        [typeof(SigningViewModel)] = () => new SigningView(),
    };

    /// <summary>The view models that have a view.</summary>
    internal static IEnumerable<Type> ViewModels => All.Keys;

    /// <inheritdoc/>
    public bool Match(object? data) => data is not null && All.ContainsKey(data.GetType());

    /// <inheritdoc/>
    public Control? Build(object? param) => param is null ? null : All[param.GetType()]();
}
